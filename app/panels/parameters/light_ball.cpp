// SPDX-License-Identifier: MIT
#include "app/panels/parameters/light_ball.h"

#include <imgui.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>

#include "app/panels/widgets/held_drag.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "app/workbench/camera_control.h"

namespace inkbench {
namespace {

constexpr float kBallSize = 72;
constexpr int kRings = 10, kSpokes = 40;
constexpr float kTurn = 6.2831853F;

/// The light's direction as the camera sees it: x right, y up, z towards the eye.
glm::vec3 in_view(const Document& document, const glm::vec3& direction) {
  const glm::vec3 turned = glm::mat3(view_matrix(document.settings().camera)) * direction;
  const float length = glm::length(turned);
  return length > 1e-6F ? turned / length : glm::vec3(0, 0, 1);
}

ImU32 shade_of(const glm::vec3& normal, const glm::vec3& light) {
  const float lit = std::max(glm::dot(normal, light), 0.0F);
  const auto part = [&](float dark, float bright) {
    return static_cast<int>(std::lround(dark + (bright - dark) * lit));
  };
  return ImGui::GetColorU32(IM_COL32(part(38, 244), part(41, 242), part(47, 236), 255));
}

/// Rings of vertices whose colours the GPU blends.
void draw_ball(ImDrawList& list, ImVec2 centre, float radius, const glm::vec3& light) {
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  const auto vertex = [&](int ring, int spoke) {
    const float out = static_cast<float>(ring) / kRings;
    const float angle = kTurn * static_cast<float>(spoke) / kSpokes;
    const glm::vec3 normal(out * std::cos(angle), out * std::sin(angle), std::sqrt(1 - out * out));
    list.PrimWriteVtx({centre.x + radius * normal.x, centre.y - radius * normal.y}, white,
                      shade_of(normal, light));
  };
  list.PrimReserve(kRings * kSpokes * 6, kRings * kSpokes * 4);
  for (int ring = 0; ring < kRings; ++ring) {
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const auto first = static_cast<ImDrawIdx>(list._VtxCurrentIdx);
      for (const int corner : {0, 1, 2, 0, 2, 3}) list.PrimWriteIdx(static_cast<ImDrawIdx>(first + corner));
      vertex(ring, spoke);
      vertex(ring + 1, spoke);
      vertex(ring + 1, spoke + 1);
      vertex(ring, spoke + 1);
    }
  }
}

void drag(Document& document, const RowContext& row, ImVec2 low, float size) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated()) document.begin_edit();
  const ImVec2 place = ImGui::IsItemActive() ? drag_place() : ImVec2();
  const bool moved = io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F;
  if (ImGui::IsItemActive() && moved) {
    const glm::vec2 now(place.x - low.x, place.y - low.y);
    const glm::vec2 before = now - glm::vec2(drag_step().x, drag_step().y);
    document.change(row.key, drag_light(std::get<glm::vec3>(row.value), document.settings().camera, before,
                                        now, {size, size}));
  }
  if (ImGui::IsItemDeactivated()) document.end_edit();
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) document.reset(row.key);
}

}  // namespace

bool is_light_direction(const RowContext& row) {
  return row.key.starts_with("light.") && row.field->name == "direction";
}

void light_ball(Document& document, UiMap& ui_map, const RowContext& row) {
  const float size = scaled(kBallSize);
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + row.name_width + scaled(14));
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("ball", {std::min(size, room), size},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui_map.mark_item("ball:" + row.key);
  drag(document, row, low, size);
  const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
  help_for_item("Drag to turn the light about the scene, as the camera sees it. Right click resets.");
  const glm::vec3 light = in_view(document, std::get<glm::vec3>(row.value));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 centre{low.x + size / 2, low.y + size / 2};
  const float radius = size / 2 - scaled(2);
  draw_ball(list, centre, radius, light);
  const ImU32 rim = ImGui::GetColorU32(hot ? theme().accent : theme().line);
  list.AddCircle(centre, radius, rim, kSpokes, scaled(hot ? 2 : 1));
  const ImVec2 dot{centre.x + radius * light.x, centre.y - radius * light.y};
  const ImU32 accent = ImGui::GetColorU32(theme().accent);
  if (light.z >= 0) {
    list.AddCircleFilled(dot, scaled(4), accent);
  } else {
    list.AddCircle(dot, scaled(4), accent, 0, scaled(1.5F));  // behind the ball
  }
}

}  // namespace inkbench
