#include "app/panels/camera_mouse.h"

#include <imgui.h>

#include "app/workbench/camera_control.h"

namespace inkbench {
namespace {

constexpr float kStepPixels = 20.0F;  // of a drag that moves nearer or farther by one step of the wheel

void set_camera(Workbench& bench, const CameraParams& camera) {
  Settings next = bench.settings();
  next.camera = camera;
  bench.replace(next);
}

/// Where the mouse is in the shown picture, and how large the picture stands in the window.
struct PictureMouse {
  glm::vec2 now{0}, before{0};
  ViewSize size;
};

PictureMouse mouse_in(const Workbench& bench, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto scale = static_cast<float>(magnification(bench.view, frame));
  const PicturePoint point = point_under(bench.view, frame, io.MousePos.x, io.MousePos.y);
  PictureMouse mouse;
  mouse.now = glm::vec2(point.x, point.y) * scale;
  mouse.before = mouse.now - glm::vec2(io.MouseDelta.x, io.MouseDelta.y);
  mouse.size = {static_cast<float>(frame.picture_width) * scale,
                static_cast<float>(frame.picture_height) * scale};
  return mouse;
}

void move_camera(Workbench& bench, const TileFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 delta = io.MouseDelta;
  if (delta.x == 0.0F && delta.y == 0.0F) return;
  const CameraParams& camera = bench.settings().camera;
  const PictureMouse mouse = mouse_in(bench, frame);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    set_camera(bench, dolly(camera, (delta.x - delta.y) / kStepPixels));
  } else if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || io.KeyShift) {
    set_camera(bench, pan(camera, mouse.before, mouse.now, mouse.size));
  } else {
    set_camera(bench, orbit_drag(camera, mouse.before, mouse.now, mouse.size));
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
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) {
    const PictureMouse mouse = mouse_in(bench, frame);
    set_camera(bench, dolly_at(bench.settings().camera, io.MouseWheel, mouse.now, mouse.size));
  }
  return true;
}

}  // namespace inkbench
