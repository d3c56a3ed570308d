// SPDX-License-Identifier: MIT
#include "app/panels/study/study_chart_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/pictures/fitted_picture.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

/// Until a chart is read.
constexpr float kUsualAspect = 1.5F;
constexpr float kTallest = 4.0F;  // times as high as wide

void zoom_by_wheel(float& zoom) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsWindowHovered() || !io.KeyCtrl || io.MouseWheel == 0) return;
  zoom = std::clamp(zoom * std::pow(1.2F, io.MouseWheel), 1.0F, kLargestChart);
}

/// Returns whether it was clicked.
bool draw_chart(UiMap& ui_map, const DrawnChart& chart, float width, Thumbnails& thumbnails) {
  const bool is_near = ImGui::IsRectVisible({width, width / kUsualAspect});
  const int width_px = static_cast<int>(width);
  const Texture* texture =
      is_near ? thumbnails.get(chart.png, width_px, static_cast<int>(width * kTallest)) : nullptr;
  float height = std::floor(width / kUsualAspect);
  if (texture != nullptr)
    height = std::floor(width * static_cast<float>(texture->height_px()) /
                        static_cast<float>(texture->width_px()));
  const std::string problem = texture == nullptr ? thumbnails.problem(chart.png) : "";
  if (!problem.empty()) {
    wrapped_text(problem, theme().error);
    return false;
  }
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(chart.name.c_str(), {width, height});
  ui_map.mark_item("chart:" + chart.name);
  help_for_item("Click shows it as SVG in the program that your desktop has for it.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (texture == nullptr) list.AddRectFilled(low, {low.x + width, low.y + height}, theme().field);
  if (texture != nullptr) draw_fitted_picture(list, *texture, low, {width, height});
  list.AddRect(low, {low.x + width, low.y + height}, ImGui::IsItemHovered() ? theme().accent : theme().line);
  return clicked;
}

}  // namespace

std::filesystem::path draw_study_charts(UiMap& ui_map, const std::vector<DrawnChart>& charts, float& zoom,
                                        Thumbnails& thumbnails) {
  std::filesystem::path clicked;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::BeginChild("charts", {0, 0}, false,
                    ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  zoom_by_wheel(zoom);
  const float room = ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize - scaled(2);
  for (const DrawnChart& chart : charts) {
    if (draw_chart(ui_map, chart, std::floor(room * zoom), thumbnails)) clicked = chart.svg;
    ImGui::Dummy({0, scaled(6)});
  }
  ImGui::EndChild();
  return clicked;
}

}  // namespace inkbench
