#include "app/panels/pictures/camera_mouse.h"

#include <imgui.h>

#include <glm/vec2.hpp>

#include "app/workbench/camera_control.h"

namespace inkbench {
namespace {

constexpr double kDragStepsPerPixel = 0.05;

void set_camera(Workbench& bench, const CameraParams& camera) {
  Settings next = bench.settings();
  next.camera = camera;
  bench.replace(next);
}

/// The shown picture as the camera's functions see it: at its size in the window.
struct ShownImage {
  ViewSize size;
  glm::vec2 mouse, before;
};

ShownImage shown_image(const Workbench& bench, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto scale = static_cast<float>(magnification(bench.view, frame));
  const auto at = [&](float x, float y) {
    const PicturePoint point = point_under(bench.view, frame, x, y);
    return glm::vec2(point.x * scale, point.y * scale);
  };
  return {{static_cast<float>(frame.picture_width) * scale, static_cast<float>(frame.picture_height) * scale},
          at(io.MousePos.x, io.MousePos.y),
          at(io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y)};
}

void drag_camera(Workbench& bench, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x == 0.0F && io.MouseDelta.y == 0.0F) return;
  const CameraParams& camera = bench.settings().camera;
  const ShownImage image = shown_image(bench, frame);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    set_camera(bench, dolly(camera, kDragStepsPerPixel * (io.MouseDelta.x - io.MouseDelta.y)));
  } else if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || io.KeyShift) {
    set_camera(bench, pan(camera, image.before, image.mouse, image.size));
  } else {
    set_camera(bench, orbit_drag(camera, image.before, image.mouse, image.size));
  }
}

}  // namespace

bool camera_mouse(Workbench& bench, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool wanted = io.KeyAlt || bench.view.tool == MouseTool::camera;
  const bool moving = bench.view.camera_moving && ImGui::IsItemActive();
  if (ImGui::IsItemDeactivated() && bench.view.camera_moving) {
    bench.view.camera_moving = false;
    bench.end_edit();
  }
  if (!wanted && !moving) return false;
  if (ImGui::IsItemActivated()) {
    bench.view.camera_moving = true;
    bench.begin_edit();
  }
  if (ImGui::IsItemActive() && bench.view.camera_moving) drag_camera(bench, frame);
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F)
    set_camera(bench, dolly_at(bench.settings().camera, io.MouseWheel, shown_image(bench, frame).mouse,
                               shown_image(bench, frame).size));
  return true;
}

}  // namespace inkbench
