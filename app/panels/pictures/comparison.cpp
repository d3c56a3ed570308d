// SPDX-License-Identifier: MIT
#include "app/panels/pictures/comparison.h"

#include <algorithm>
#include <cmath>

#include "app/panels/pictures/picture_tile.h"
#include "app/panels/widgets/held_drag.h"
#include "app/window/listed_buffers.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

std::string label_of(const Pictures& pictures, const char* side, const ComparedPicture& which) {
  std::string text = std::string(side) + "  " + std::string(name_of(which.buffer));
  if (pictures.pinned_settings()) text += which.pinned ? ", pinned" : ", now";
  return text;
}

void draw_label(const std::string& text, ImVec2 place, bool at_right) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 pad{scaled(8), scaled(4)};
  const ImVec2 low{at_right ? place.x - size.x - 2 * pad.x : place.x, place.y};
  const ImVec2 high{low.x + size.x + 2 * pad.x, low.y + size.y + 2 * pad.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, with_alpha(theme().bar, 0.9F), scaled(3));
  list.AddText({low.x + pad.x, low.y + pad.y}, theme().text, text.c_str());
}

float split_x(const ViewState& view, const TileRect& rect) {
  return std::round(rect.low.x + static_cast<float>(view.comparison.split) * rect.width());
}

/// The line between A and B takes the mouse before the pictures do. Returns whether it is under the mouse.
bool handle_divider(ViewState& view, UiMap& ui_map, const TileRect& rect) {
  const float grip = scaled(6);
  ImGui::SetCursorScreenPos({split_x(view, rect) - grip, rect.low.y});
  ImGui::InvisibleButton("split", {2 * grip, std::max(rect.height(), 1.0F)});
  ui_map.mark_item("split");
  const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (const auto before = given_back(view.comparison.split)) view.comparison.split = *before;
  if (ImGui::IsItemActive()) {
    const double share = (ImGui::GetIO().MousePos.x - rect.low.x) / std::max(rect.width(), 1.0F);
    view.comparison.split = std::clamp(share, 0.0, 1.0);
  }
  return hot;
}

void draw_divider(const ViewState& view, const TileRect& rect, bool hot) {
  const float x = split_x(view, rect);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({x, rect.low.y}, {x, rect.high.y}, theme().accent, hot ? scaled(3) : scaled(2));
  list.AddCircleFilled({x, (rect.low.y + rect.high.y) / 2}, scaled(hot ? 7 : 6), theme().accent);
}

/// The one before it in the table; before the first, the last.
BufferName buffer_before(BufferName buffer) {
  const std::vector<BufferName> buffers = all_buffers();
  const auto place = std::find(buffers.begin(), buffers.end(), buffer);
  return place == buffers.begin() ? buffers.back() : *(place - 1);
}

}  // namespace

void draw_comparison(Document& document, Viewer& viewer, ViewState& view, UiMap& ui_map, ImVec2 low,
                     ImVec2 room) {
  const Comparison& comparison = view.comparison;
  const TileRect rect{low, {std::floor(low.x + room.x), std::floor(low.y + room.y)}};
  const bool hot = !comparison.flips && handle_divider(view, ui_map, rect);
  const float x = split_x(view, rect);
  const bool mouse_on_b = comparison.flips ? comparison.shows_b : ImGui::GetIO().MousePos.x >= x;
  const ComparedPicture& under = mouse_on_b ? comparison.b : comparison.a;
  handle_tile_mouse(document, viewer, view, ui_map, "tile:comparison", under, rect);
  TileRect left = rect;
  TileRect right = rect;
  if (!comparison.flips) left.high.x = right.low.x = x;
  if (!comparison.flips || !comparison.shows_b)
    draw_picture(document, viewer, view, "A", comparison.a, rect, left);
  if (!comparison.flips || comparison.shows_b)
    draw_picture(document, viewer, view, "B", comparison.b, rect, right);
  ImGui::GetWindowDrawList()->AddRect(rect.low, rect.high, theme().line);
  if (!comparison.flips) draw_divider(view, rect, hot);
  const float in = scaled(8);
  if (!comparison.flips || !comparison.shows_b)
    draw_label(label_of(viewer.pictures, "A", comparison.a), {rect.low.x + in, rect.low.y + in}, false);
  if (!comparison.flips || comparison.shows_b)
    draw_label(label_of(viewer.pictures, "B", comparison.b), {rect.high.x - in, rect.low.y + in}, true);
}

void pin_state(Viewer& viewer, ViewState& view) {
  viewer.pin();
  Comparison& comparison = view.comparison;
  if (!viewer.pictures.pinned_settings() || !comparison.active) return;
  comparison.a = {comparison.b.buffer, true};
  comparison.b.pinned = false;
}

void toggle_comparison(Pictures& pictures, ViewState& view) {
  Comparison& comparison = view.comparison;
  if (comparison.active) {
    comparison.active = false;
    return;
  }
  const bool pinned = pictures.pinned_settings().has_value();
  const BufferName selected = looked_at(view);
  const BufferName before = buffer_before(selected);
  if (comparison.a == comparison.b || comparison.a.buffer != selected || comparison.a.pinned != pinned) {
    comparison.a = {selected, pinned};
    comparison.b = {pinned ? selected : before, false};
  }
  comparison.active = true;
}

}  // namespace inkbench
