// SPDX-License-Identifier: MIT
#include "app/panels/pictures/contact_sheet.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/panels/pictures/comparison.h"
#include "app/panels/pictures/overlay_legend.h"
#include "app/panels/pictures/picture_menu.h"
#include "app/panels/pictures/picture_tile.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/listed_buffers.h"
#include "app/window/pictures.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

struct SheetGrid {
  int columns = 1, rows = 1;
  float width = 0, height = 0;  ///< Of a picture.
};

float caption_height() {
  return ImGui::GetFontSize() + scaled(6);
}

float gap() {
  return scaled(10);
}

/// The number of columns with the largest pictures.
SheetGrid best_grid(int count, ImVec2 room, float aspect) {
  SheetGrid best;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const float across = (room.x - gap() * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    const float down =
        (room.y - gap() * static_cast<float>(rows - 1)) / static_cast<float>(rows) - caption_height();
    const float width = std::floor(std::min(across, down * aspect));
    if (width > best.width) best = {columns, rows, width, std::floor(width / aspect)};
  }
  return best;
}

std::string range_note(const ShownPicture& shown) {
  if (shown.is_late) return "…";
  if (!shown.range) return "";
  return shortest(std::round(shown.range->black * 1e4F) / 1e4F) + " to " +
         shortest(std::round(shown.range->white * 1e4F) / 1e4F);
}

/// The key that fills the window with it; nothing where it has none.
std::string number_key(BufferName buffer) {
  const int key = buffer.info().number_key;
  return key < 0 ? "" : std::to_string(key);
}

/// `shown`: the mouse is on the picture.
void draw_fit_button(Pictures& pictures, UiMap& ui_map, BufferName buffer, ImVec2 right_top, float height,
                     bool shown) {
  PictureChoice& choice = pictures.choice(buffer);
  const bool fitted = choice.kind == PictureChoice::Kind::fitted;
  const float width = ImGui::CalcTextSize("fit").x + scaled(8);
  ImGui::SetCursorScreenPos({right_top.x - width, right_top.y});
  const std::string id = "fit:" + std::string(name_of(buffer));
  if (ImGui::InvisibleButton(id.c_str(), {width, height})) toggle_fit(choice);
  ui_map.mark_item(id);
  ImU32 colour = fitted ? theme().accent : theme().faint;
  if (ImGui::IsItemHovered()) colour = theme().text;
  if (!fitted && !shown && !ImGui::IsItemHovered()) return;
  ImGui::GetWindowDrawList()->AddText({right_top.x - width + scaled(4), right_top.y + scaled(3)}, colour,
                                      "fit");
  help_for_item("Show the smallest value as black and the largest as white. Files keep the display gains.");
}

void draw_caption(Pictures& pictures, const ViewState& view, UiMap& ui_map, BufferName buffer,
                  const TileRect& picture, bool hovered) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = picture.low.y - caption_height();
  const float text_y = top + scaled(3);
  const ShownPicture& shown = pictures.shown(buffer, false);
  float right = picture.high.x;
  float x = picture.low.x + scaled(1);
  list.AddText({x, text_y}, theme().faint, number_key(buffer).c_str());
  x += ImGui::CalcTextSize("0").x + scaled(6);
  const float button = ImGui::CalcTextSize("fit").x + scaled(10);
  const bool fitted = pictures.choice(buffer).kind == PictureChoice::Kind::fitted;
  const bool has_room = ImGui::CalcTextSize(name_of(buffer).data()).x + button <= right - x;
  if (has_range(buffer) && (fitted || has_room)) {  // else the picture's menu has it
    draw_fit_button(pictures, ui_map, buffer, {right, top}, caption_height(), hovered);
    if (fitted || hovered) right -= button;
  }
  const ImU32 colour = view.selected == buffer ? theme().accent : theme().text;
  x += draw_fitted_text(list, {x, text_y}, right - x, colour, name_of(buffer)) + scaled(8);
  const std::string note = range_note(shown);
  if (!note.empty() && ImGui::CalcTextSize(note.c_str()).x < right - x)
    list.AddText({x, text_y}, theme().faint, note.c_str());
}

/// Over a picture that holds nothing: what it lacks.
void draw_lack(UiMap& ui_map, BufferName buffer, const Settings& settings, const TileRect& picture) {
  const std::string lack = lacking_for(buffer, settings);
  if (lack.empty()) return;
  const std::string text = "Empty without\n" + lack;
  const float edge = scaled(6);
  const float room = picture.width() - 4 * edge;
  if (room < ImGui::GetFontSize() || picture.height() < 2 * ImGui::GetFontSize()) return;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, room);
  const ImVec2 low{std::round((picture.low.x + picture.high.x - size.x) / 2),
                   std::round((picture.low.y + picture.high.y - size.y) / 2)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(picture.low, picture.high, true);
  list.AddRectFilled({low.x - edge, low.y - edge}, {low.x + size.x + edge, low.y + size.y + edge},
                     with_alpha(theme().bar, 0.9F), scaled(3));
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), low, theme().text, text.c_str(), nullptr, room);
  list.PopClipRect();
  ui_map.mark("lack:" + std::string(name_of(buffer)), {low.x, low.y, low.x + size.x, low.y + size.y});
}

}  // namespace

void ContactSheet::draw_tile(BufferName buffer, const TileRect& picture) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string name(name_of(buffer));
  const ComparedPicture which{buffer, false};
  const TileMouse mouse =
      handle_tile_mouse(document_, viewer_, view_, ui_map_, "tile:" + name, which, picture);
  draw_picture_menu(document_, viewer_.pictures, view_, problems_, wanted_dialog_, ui_map_, buffer);
  if (mouse.clicked) view_.selected = buffer;
  if (mouse.double_clicked) {
    view_.filled = view_.filled ? std::nullopt : std::optional(buffer);
  }
  draw_picture(document_, viewer_, view_, name, which, picture, picture);
  draw_lack(ui_map_, buffer, document_.settings(), picture);
  const bool selected = view_.selected == buffer;
  const float out = selected ? scaled(1) : 0;
  list.AddRect({picture.low.x - out, picture.low.y - out}, {picture.high.x + out, picture.high.y + out},
               selected ? theme().accent : theme().line, 0, 0, selected ? scaled(2) : 1.0F);
  draw_caption(viewer_.pictures, view_, ui_map_, buffer, picture, mouse.hovered);
}

void ContactSheet::draw_sheet(ImVec2 low, ImVec2 room) {
  std::vector<BufferName> listed;
  for (const BufferName buffer : all_buffers()) {
    if (is_listed(layout_, buffer)) listed.push_back(buffer);
  }
  const ImageParams& image = document_.settings().image;
  const SheetGrid grid = best_grid(static_cast<int>(listed.size()), room,
                                   static_cast<float>(image.width) / static_cast<float>(image.height));
  if (grid.width < 1) return;
  const float across = grid.width + gap();
  const float down = grid.height + caption_height() + gap();
  const float left = low.x + (room.x - across * static_cast<float>(grid.columns) + gap()) / 2;
  const float top = low.y + (room.y - down * static_cast<float>(grid.rows) + gap()) / 2;
  for (size_t i = 0; i < listed.size(); ++i) {
    const auto column = static_cast<float>(i % grid.columns);
    const auto row = static_cast<float>(i / grid.columns);
    const ImVec2 at{std::floor(left + column * across), std::floor(top + row * down + caption_height())};
    draw_tile(listed[i], {at, {at.x + grid.width, at.y + grid.height}});
  }
}

void ContactSheet::draw() {
  view_.hovered.reset();
  view_.curve_words.clear();
  const float edge = scaled(12);
  ImVec2 low = ImGui::GetCursorScreenPos();
  ImVec2 room = ImGui::GetContentRegionAvail();
  low = {std::floor(low.x + edge), std::floor(low.y + scaled(6))};
  room = {room.x - 2 * edge, room.y - scaled(6) - edge};
  if (room.x < scaled(20) || room.y < scaled(20)) return;
  if (view_.comparison.active) {
    draw_comparison(document_, viewer_, view_, ui_map_, low, room);
  } else if (view_.filled) {
    const ImVec2 top{low.x, low.y + caption_height()};
    draw_tile(*view_.filled, {top, {std::floor(low.x + room.x), std::floor(low.y + room.y)}});
  } else {
    draw_sheet(low, room);
  }
  draw_overlay_legend(viewer_, layout_, ui_map_, {low.x, low.y + room.y}, room.x);
}

}  // namespace inkbench
