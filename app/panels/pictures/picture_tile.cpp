// SPDX-License-Identifier: MIT
#include "app/panels/pictures/picture_tile.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/panels/pictures/camera_mouse.h"
#include "app/panels/pictures/curve_hover.h"
#include "app/panels/pictures/mark.h"
#include "app/panels/pictures/mark_brush.h"
#include "app/panels/widgets/held_drag.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

constexpr double kWheelFactor = 1.2;

const ShownPicture& picture_of(const Pictures& pictures, const ComparedPicture& which) {
  return pictures.shown(which.buffer, which.pinned);
}

void remember_hover(ViewState& view, const ComparedPicture& which, const TileFrame& frame) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const PicturePoint point = point_under(view, frame, mouse.x, mouse.y);
  const int x = static_cast<int>(std::floor(point.x));
  const int y = static_cast<int>(std::floor(point.y));
  const bool inside = x >= 0 && y >= 0 && x < frame.picture_width && y < frame.picture_height;
  if (inside) view.hovered = HoveredPixel{which, x, y};
}

void move_view(ViewState& view, const TileFrame& frame, bool dragging) {
  const ImGuiIO& io = ImGui::GetIO();
  const double wheel = static_cast<double>(io.MouseWheel);
  if (const auto before = given_back(std::pair(view.centre_x, view.centre_y)))
    std::tie(view.centre_x, view.centre_y) = *before;
  if (ImGui::IsItemHovered() && wheel != 0.0)
    zoom_about(view, frame, io.MousePos.x, io.MousePos.y, std::pow(kWheelFactor, wheel));
  if (dragging) pan_by(view, frame, io.MouseDelta.x, io.MouseDelta.y);
}

/// Pinned pictures and the lines themselves have none; one of another size is of settings a moment ago.
TileOverlay overlay_for(Viewer& viewer, const ComparedPicture& which, const Texture& picture) {
  if (which.pinned || which.buffer == BufferName::reference) return {};
  const TileOverlay overlay = viewer.overlay();
  const bool fits = overlay.texture != nullptr && overlay.texture->width_px() == picture.width_px() &&
                    overlay.texture->height_px() == picture.height_px();
  return fits ? overlay : TileOverlay{};
}

/// Over the picture that was just drawn. What cannot be drawn is told by the pictures themselves.
void draw_wires(Viewer& viewer, const TilePlace& place, const TileRect& rect) {
  if (!viewer.can_draw() || !viewer.drawn()) return;
  const ImVec4 colour = as_vec4(theme().accent);
  const WireView view{place,
                      static_cast<int>(rect.width()),
                      static_cast<int>(rect.height()),
                      {colour.x, colour.y, colour.z, 1.0F}};
  const Texture& wires = viewer.wires.paint(*viewer.drawn(), view);
  ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(wires.id())),
                                       rect.low, rect.high, {0, 1}, {1, 0});
}

}  // namespace

TileFrame frame_of(const Pictures& pictures, const ComparedPicture& which, const TileRect& rect) {
  const ShownPicture& shown = picture_of(pictures, which);
  TileFrame frame{rect.low.x, rect.low.y, std::max(rect.width(), 1.0F), std::max(rect.height(), 1.0F)};
  if (shown.texture != nullptr) {
    frame.picture_width = shown.texture->width_px();
    frame.picture_height = shown.texture->height_px();
  }
  return frame;
}

void draw_picture(const Document& document, Viewer& viewer, ViewState& view, const std::string& slot,
                  const ComparedPicture& which, const TileRect& rect, const TileRect& clip) {
  const ShownPicture& shown = picture_of(viewer.pictures, which);
  const int width = static_cast<int>(rect.width());
  const int height = static_cast<int>(rect.height());
  if (shown.texture == nullptr || width < 1 || height < 1) return;
  const TileFrame frame = frame_of(viewer.pictures, which, rect);
  if (view.wanted_magnification) set_magnification(view, frame, *view.wanted_magnification);
  view.wanted_magnification.reset();
  view.magnification = magnification(view, frame);
  const PicturePoint corner = point_under(view, frame, frame.left, frame.top);
  // The picture's corner on a whole window pixel: one to one is exactly that, and magnified pixels are even.
  const double scale = magnification(view, frame);
  const TilePlace place{std::round(corner.x * scale) / scale, std::round(corner.y * scale) / scale,
                        1.0 / scale};
  const Texture& tile = viewer.tiles.paint(slot, *shown.texture, shown.key, place, width, height,
                                           overlay_for(viewer, which, *shown.texture));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(clip.low, clip.high, true);
  list.AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(tile.id())), rect.low, rect.high, {0, 1},
                {1, 0});
  if (view.wireframe && !which.pinned) draw_wires(viewer, place, rect);
  if (!which.pinned) draw_marks(document, viewer, view, frame);
  draw_mark(view, frame);
  if (view.hovered && view.hovered->picture == which) draw_curve_under_mouse(viewer, view, which, frame);
  list.PopClipRect();
}

TileMouse handle_tile_mouse(Document& document, Viewer& viewer, ViewState& view, UiMap& ui_map,
                            const std::string& id, const ComparedPicture& which, const TileRect& rect) {
  ImGui::SetCursorScreenPos(rect.low);
  ImGui::InvisibleButton(id.c_str(), {std::max(rect.width(), 1.0F), std::max(rect.height(), 1.0F)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  ui_map.mark_item(id);
  const TileFrame frame = frame_of(viewer.pictures, which, rect);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) remember_hover(view, which, frame);
  if (!which.pinned && brush_mouse(document, viewer, view, frame)) {
    if (!ImGui::GetIO().KeyCtrl)
      move_view(view, frame, ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0F));
    return {hovered};
  }
  mark_with_mouse(view, frame, which.pinned);
  if (!which.pinned && camera_mouse(document, view, frame)) return {hovered};
  const bool held = ImGui::IsItemActive();
  const bool dragging = held && (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0F) ||
                                 ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0F));
  move_view(view, frame, dragging);
  return {hovered, ImGui::IsItemClicked(), hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)};
}

}  // namespace inkbench
