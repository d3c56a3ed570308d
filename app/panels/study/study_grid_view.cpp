// SPDX-License-Identifier: MIT
#include "app/panels/study/study_grid_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/pictures/fitted_picture.h"
#include "app/panels/study/study_cell_tooltip.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

void draw_waiting(ImDrawList& list, ImVec2 low, ImVec2 high) {
  list.AddRectFilled(low, high, theme().field);
}

/// Hatched, as in grid.png.
void draw_failed(ImDrawList& list, ImVec2 low, ImVec2 high) {
  list.AddRectFilled(low, high, theme().field);
  list.PushClipRect(low, high, true);
  const float height = high.y - low.y;
  for (float x = low.x - height; x < high.x; x += scaled(9))
    list.AddLine({x, high.y}, {x + height, low.y}, theme().line);
  list.PopClipRect();
  const ImVec2 size = ImGui::CalcTextSize("failed");
  list.AddText({(low.x + high.x - size.x) / 2, (low.y + high.y - size.y) / 2}, theme().error, "failed");
}

void draw_thumbnail(const StudyResults& results, size_t cell, const GridChoice& choice,
                    Thumbnails& thumbnails, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::filesystem::path file = results.picture(cell, choice.picture);
  if (file.empty())
    return results.error(cell).empty() ? draw_waiting(list, low, high) : draw_failed(list, low, high);
  const ImVec2 room{high.x - low.x, high.y - low.y};
  const Texture* texture = thumbnails.get(file, static_cast<int>(room.x), static_cast<int>(room.y));
  if (texture != nullptr) return draw_fitted_picture(list, *texture, low, room);
  draw_waiting(list, low, high);
  if (!thumbnails.problem(file).empty())
    list.AddText({low.x + scaled(4), low.y + scaled(4)}, theme().error, "?");
}

void draw_centred(ImDrawList& list, ImVec2 low, float width, ImU32 colour, const std::string& text) {
  const float own = text_width(text);
  if (own <= width) {
    list.AddText({std::floor(low.x + (width - own) / 2), low.y}, colour, text.c_str());
  } else {
    draw_fitted_text(list, low, width, colour, text);
  }
}

class GridView {
 public:
  GridView(const Document& document, UiMap& ui_map, const StudyResults& results, GridChoice& choice,
           Thumbnails& thumbnails)
      : document_(document), ui_map_(ui_map), results_(results), choice_(choice), thumbnails_(thumbnails) {}

  GridMouse draw() {
    room_ = ImGui::GetContentRegionAvail();
    plan_ = plan_of(results_, choice_, room_);
    ImGui::SetNextWindowContentSize(plan_.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::BeginChild("grid", {0, 0}, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoBackground);
    ImGui::PopStyleVar();
    zoom_by_wheel();
    window_ = ImGui::GetWindowPos();
    inner_ = {ImGui::GetWindowContentRegionMax().x + ImGui::GetScrollX(), ImGui::GetWindowHeight()};
    origin_ = ImGui::GetCursorScreenPos();
    // A grid that is smaller than the room stands in its middle.
    origin_.x += std::max(0.0F, std::floor((room_.x - plan_.size().x) / 2));
    draw_cells();
    draw_labels();
    ImGui::EndChild();
    return mouse_;
  }

 private:
  void zoom_by_wheel() {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsWindowHovered() || !io.KeyCtrl || io.MouseWheel == 0) return;
    choice_.zoom = std::clamp(choice_.zoom * std::pow(1.2F, io.MouseWheel), 1.0F, kLargestGrid);
  }

  std::pair<size_t, size_t> in_sight(float begin, float first, float step, float low, float high,
                                     size_t count) const {
    const float from = std::floor((low - begin - first) / step),
                to = std::ceil((high - begin - first) / step);
    const auto clamp = [&](float value) {
      return static_cast<size_t>(std::clamp(value, 0.0F, static_cast<float>(count)));
    };
    return {clamp(from), clamp(to)};
  }

  void draw_cells() {
    const ImVec2 end{window_.x + ImGui::GetWindowWidth(), window_.y + ImGui::GetWindowHeight()};
    const auto [first_row, last_row] =
        in_sight(origin_.y, plan_.top, plan_.down(), window_.y, end.y, plan_.rows);
    const auto [first_column, last_column] =
        in_sight(origin_.x, plan_.left, plan_.across(), window_.x, end.x, plan_.columns);
    columns_ = {first_column, last_column};
    rows_ = {first_row, last_row};
    for (size_t row = first_row; row < last_row; ++row) {
      for (size_t column = first_column; column < last_column; ++column) {
        const size_t place = row * plan_.columns + column;
        if (place < plan_.count) draw_cell(row, column, results_.cell_at(0, 0, choice_.page) + place);
      }
    }
  }

  ImVec2 corner(size_t row, size_t column) const {
    return {origin_.x + plan_.left + plan_.across() * static_cast<float>(column),
            origin_.y + plan_.top + plan_.down() * static_cast<float>(row) +
                (plan_.flows ? plan_.value_height : 0)};
  }

  void draw_cell(size_t row, size_t column, size_t cell) {
    const ImVec2 low = corner(row, column);
    const ImVec2 high{low.x + plan_.cell.x, low.y + plan_.cell.y};
    ImGui::SetCursorScreenPos(low);
    ImGui::PushID(static_cast<int>(cell));
    const bool pressed = ImGui::InvisibleButton("cell", plan_.cell);
    ui_map_.mark_item("cell:" + std::to_string(cell + 1));
    const bool hot = ImGui::IsItemHovered();
    if (pressed && results_.has(cell)) mouse_.clicked = cell;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) mouse_.menu = cell;
    draw_thumbnail(results_, cell, choice_, thumbnails_, low, high);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool taken = choice_.taken == cell;
    if (hot || taken) {
      const float out = taken ? scaled(1) : 0;
      list.AddRect({low.x - out, low.y - out}, {high.x + out, high.y + out}, theme().accent, 0, 0,
                   taken ? scaled(2) : 1.0F);
    } else {
      list.AddRect(low, high, theme().line);
    }
    if (plan_.flows)
      draw_centred(
          list, {low.x, low.y - plan_.value_height}, plan_.cell.x, theme().faint,
          fitting_value(results_.columns().values[row * plan_.columns + column], plan_.cell.x, plan_.digits));
    if (choice_.number)
      draw_centred(list, {low.x, high.y + scaled(1)}, plan_.cell.x, theme().text,
                   short_number(results_.number(cell, *choice_.number)));
    if (hot)
      draw_cell_tooltip(results_, cell, choice_.picture, thumbnails_, plan_.cell, document_.settings().image);
    ImGui::PopID();
  }

  /// They stay in sight when the cells are scrolled.
  void draw_labels() {
    if (plan_.top == 0) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = ImGui::GetWindowWidth(), height = ImGui::GetWindowHeight();
    const GridAxis& columns = results_.columns();
    const bool scrolls_up = ImGui::GetScrollMaxY() > 0, scrolls_across = ImGui::GetScrollMaxX() > 0;
    const float top = scrolls_up ? window_.y : origin_.y;
    if (scrolls_up) list.AddRectFilled(window_, {window_.x + width, window_.y + plan_.top}, theme().panel);
    const float cells_left = origin_.x + plan_.left;
    const float shown_width = std::min(plan_.size().x - plan_.left, width - plan_.left);
    const ImVec2 title{std::max(cells_left, window_.x + plan_.left), top};
    draw_centred(list, title, shown_width, theme().text, columns.label);
    if (!plan_.flows) {
      for (size_t column = columns_.first; column < columns_.second; ++column)
        draw_centred(list, {corner(0, column).x, top + plan_.value_height}, plan_.cell.x, theme().faint,
                     fitting_value(columns.values[column], plan_.cell.x, plan_.digits));
    }
    if (plan_.left == 0) return;
    const GridAxis& rows = results_.rows();
    const float left = scrolls_across ? window_.x : origin_.x;
    if (scrolls_across)
      list.AddRectFilled(window_, {window_.x + plan_.left - scaled(2), window_.y + height}, theme().panel);
    const float room = plan_.left - scaled(8);
    for (size_t row = rows_.first; row < rows_.second; ++row) {
      const float middle = corner(row, 0).y + (plan_.cell.y - ImGui::GetTextLineHeight()) / 2;
      const std::string& value = rows.values[row];
      const float own = std::min(text_width(value), room);
      draw_fitted_text(list, {left + room - own, middle}, room, theme().faint, value);
    }
    if (scrolls_up || scrolls_across)
      list.AddRectFilled({left, top}, {left + plan_.left - scaled(2), top + plan_.top}, theme().panel);
    const float own = std::min(text_width(rows.label), room);
    draw_fitted_text(list, {left + room - own, top + plan_.value_height}, room, theme().text, rows.label);
  }

  const Document& document_;
  UiMap& ui_map_;
  const StudyResults& results_;
  GridChoice& choice_;
  Thumbnails& thumbnails_;
  GridPlan plan_;
  GridMouse mouse_;
  ImVec2 room_, window_, inner_, origin_;
  std::pair<size_t, size_t> columns_, rows_;
};

}  // namespace

GridMouse draw_study_grid(const Document& document, UiMap& ui_map, const StudyResults& results,
                          GridChoice& choice, Thumbnails& thumbnails) {
  return GridView(document, ui_map, results, choice, thumbnails).draw();
}

}  // namespace inkbench
