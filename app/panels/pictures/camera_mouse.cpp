// SPDX-License-Identifier: MIT
#include "app/panels/pictures/camera_mouse.h"

#include <imgui.h>
#include <glm/vec2.hpp>

#include "app/workbench/camera_control.h"

namespace inkbench {
namespace {

constexpr double kDragStepsPerPixel = 0.05;

void set_camera(Document& document, const CameraParams& camera) {
  Settings next = document.settings();
  next.camera = camera;
  document.replace(next);
}

/// The shown picture as the camera's functions see it: at its size in the window.
struct ShownImage {
  ViewSize size;
  glm::vec2 mouse, before;
};

ShownImage shown_image(const ViewState& view, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto scale = static_cast<float>(magnification(view, frame));
  const auto at = [&](float x, float y) {
    const PicturePoint point = point_under(view, frame, x, y);
    return glm::vec2(point.x * scale, point.y * scale);
  };
  return {{static_cast<float>(frame.picture_width) * scale, static_cast<float>(frame.picture_height) * scale},
          at(io.MousePos.x, io.MousePos.y),
          at(io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y)};
}

void drag_camera(Document& document, ViewState& view, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x == 0.0F && io.MouseDelta.y == 0.0F) return;
  const CameraParams& camera = document.settings().camera;
  const ShownImage image = shown_image(view, frame);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    set_camera(document, dolly(camera, kDragStepsPerPixel * (io.MouseDelta.x - io.MouseDelta.y)));
  } else if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || io.KeyShift) {
    set_camera(document, pan(camera, image.before, image.mouse, image.size));
  } else {
    set_camera(document, orbit_drag(camera, image.before, image.mouse, image.size));
  }
}

}  // namespace

bool camera_mouse(Document& document, ViewState& view, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool wanted = io.KeyAlt || view.tool == MouseTool::camera;
  const bool moving = view.camera_moving && ImGui::IsItemActive();
  if (ImGui::IsItemDeactivated() && view.camera_moving) {
    view.camera_moving = false;
    document.end_edit();
  }
  if (!wanted && !moving) return false;
  if (ImGui::IsItemActivated()) {
    view.camera_moving = true;
    document.begin_edit();
  }
  if (ImGui::IsItemActive() && view.camera_moving) drag_camera(document, view, frame);
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F)
    set_camera(document, dolly_at(document.settings().camera, io.MouseWheel, shown_image(view, frame).mouse,
                                  shown_image(view, frame).size));
  return true;
}

}  // namespace inkbench
