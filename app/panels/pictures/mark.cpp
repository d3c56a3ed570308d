// SPDX-License-Identifier: MIT
#include "app/panels/pictures/mark.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/window/theme.h"

namespace inkbench {
namespace {

constexpr float kClickMoves = 3;  ///< More is a drag.
constexpr float kSmallest = 4;    ///< Half of the mark's box.
constexpr float kTick = 6;

void draw_cross(ImDrawList& list, ImVec2 low, ImVec2 high, ImU32 colour, float width) {
  const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const float tick = scaled(kTick);
  list.AddRect(low, high, colour, 0, 0, width);
  for (const auto& [from, to] :
       std::array<std::pair<ImVec2, ImVec2>, 4>{{{{low.x, middle.y}, {low.x - tick, middle.y}},
                                                 {{high.x, middle.y}, {high.x + tick, middle.y}},
                                                 {{middle.x, low.y}, {middle.x, low.y - tick}},
                                                 {{middle.x, high.y}, {middle.x, high.y + tick}}}}) {
    list.AddLine(from, to, colour, width);
  }
}

}  // namespace

void mark_with_mouse(ViewState& view, const TileFrame& frame, bool pinned) {
  const ImGuiIO& io = ImGui::GetIO();
  const float limit = scaled(kClickMoves);
  const bool clicked = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                       io.MouseDragMaxDistanceSqr[0] < limit * limit;
  if (!clicked) return;
  if (io.MouseClickedLastCount[0] > 1) {
    view.marked = view.marked_before;
    return;
  }
  const PicturePoint point = point_under(view, frame, io.MousePos.x, io.MousePos.y);
  const MarkedPixel pixel{static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y)),
                          pinned};
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= frame.picture_width || pixel.y >= frame.picture_height) return;
  view.marked_before = view.marked;
  view.marked = pixel;
}

void move_mark(const Document& document, const Pictures& pictures, ViewState& view, int dx, int dy) {
  if (!view.marked) return;
  MarkedPixel& pixel = *view.marked;
  const bool pinned = asks_pinned(view) && pictures.pinned_settings();
  const ImageParams& image = pinned ? pictures.pinned_settings()->image : document.settings().image;
  pixel.x = std::clamp(pixel.x + dx, 0, image.width - 1);
  pixel.y = std::clamp(pixel.y + dy, 0, image.height - 1);
}

void draw_mark(const ViewState& view, const TileFrame& frame) {
  if (!view.marked) return;
  const MarkedPixel& pixel = *view.marked;
  if (pixel.x >= frame.picture_width || pixel.y >= frame.picture_height) return;
  const PicturePoint middle = point_over(view, frame, pixel.x + 0.5, pixel.y + 0.5);
  const auto half = std::max(scaled(kSmallest), static_cast<float>(magnification(view, frame) / 2) + 1);
  const ImVec2 at{std::round(static_cast<float>(middle.x)), std::round(static_cast<float>(middle.y))};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{at.x - half, at.y - half};
  const ImVec2 high{at.x + half, at.y + half};
  draw_cross(list, low, high, IM_COL32(255, 255, 255, 255), scaled(4));
  draw_cross(list, low, high, theme().mark, scaled(2));
}

}  // namespace inkbench
