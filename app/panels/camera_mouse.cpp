#include "app/panels/camera_mouse.h"

#include <imgui.h>

#include <cmath>

#include "app/window/camera_moves.h"

namespace inkbench {
namespace {

constexpr double kDegreesPerPixel = 0.4;
constexpr double kWheelFactor = 0.88;
constexpr double kDragFactor = 0.994;  // a pixel

void set_camera(Workbench& bench, const CameraParams& camera) {
  Settings next = bench.settings();
  next.camera = camera;
  bench.replace(next);
}

void move_camera(Workbench& bench, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 delta = io.MouseDelta;
  if (delta.x == 0.0F && delta.y == 0.0F) return;
  const CameraParams& camera = bench.settings().camera;
  const bool pans = ImGui::IsMouseDown(ImGuiMouseButton_Middle) || io.KeyShift;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    set_camera(bench, dollied(camera, std::pow(kDragFactor, static_cast<double>(delta.x - delta.y))));
  } else if (pans) {
    const double height_px = frame.picture_height * magnification(bench.view, frame);
    set_camera(bench, panned(camera, delta.x / height_px, delta.y / height_px));
  } else {
    set_camera(bench, orbited(camera, -delta.x * kDegreesPerPixel, delta.y * kDegreesPerPixel));
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
  if (ImGui::IsItemActive() && bench.view.camera_moving) move_camera(bench, frame);
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F)
    set_camera(bench, dollied(bench.settings().camera, std::pow(kWheelFactor, io.MouseWheel)));
  return true;
}

}  // namespace inkbench
