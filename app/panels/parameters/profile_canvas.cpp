// SPDX-License-Identifier: MIT
#include "app/panels/parameters/profile_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/panels/widgets/held_drag.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

constexpr float kPointReach = 9, kPointSize = 4, kInset = 8;
constexpr float kLineStarts = 3;     ///< Less is a click.
constexpr float kTolerance = 0.02F;  ///< Of a free line, as a share of the width.

/// Where the graph's unit square lies in the window: places to the right, shares upwards.
struct Graph {
  ImVec2 low, high;

  ImVec2 over(const ProfilePoint& point) const {
    return {low.x + point.along * (high.x - low.x), high.y - point.share * (high.y - low.y)};
  }
  ProfilePoint under(ImVec2 place) const {
    return {std::clamp((place.x - low.x) / (high.x - low.x), 0.0F, 1.0F),
            std::clamp((high.y - place.y) / (high.y - low.y), 0.0F, 1.0F)};
  }
};

std::optional<size_t> point_near(const WidthProfile& profile, const Graph& graph, ImVec2 mouse) {
  std::optional<size_t> nearest;
  float least = scaled(kPointReach);
  for (size_t i = 0; i < profile.size(); ++i) {
    const ImVec2 at = graph.over(profile[i]);
    const float distance = std::hypot(at.x - mouse.x, at.y - mouse.y);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

CanvasResult begin_drag(const WidthProfile& profile, const Graph& graph, CanvasState& state) {
  CanvasResult result{.pressed = true};
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  state = {.before = profile, .dragged = point_near(profile, graph, mouse)};
  if (!state.dragged) {
    state.drawn = {graph.under(mouse)};
    return result;
  }
  const ImVec2 at = graph.over(profile[*state.dragged]);
  state.grip = {at.x - mouse.x, at.y - mouse.y};
  if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return result;
  result.changed = state.before = remove_point(profile, *state.dragged);
  state.dragged.reset();
  return result;
}

std::optional<WidthProfile> go_on(const Graph& graph, CanvasState& state, ImVec2 mouse) {
  state.moved |= ImGui::IsMouseDragging(ImGuiMouseButton_Left, scaled(kLineStarts));
  if (!state.moved) return std::nullopt;
  if (state.dragged)
    return move_point(*state.before, *state.dragged,
                      graph.under({mouse.x + state.grip.x, mouse.y + state.grip.y}));
  if (state.drawn.empty()) return std::nullopt;  // a point was removed
  state.drawn.push_back(graph.under(mouse));
  return drawn_over(*state.before, state.drawn, kTolerance);
}

CanvasResult end_drag(CanvasState& state) {
  CanvasResult result{.released = true};
  if (!state.moved && !state.drawn.empty()) result.changed = with_point(*state.before, state.drawn.front());
  state = {};
  return result;
}

void draw_graph(const WidthProfile& profile, const Graph& graph, std::optional<size_t> hot) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(graph.low, graph.high, theme().field);
  for (int quarter = 1; quarter < 4; ++quarter) {
    const float share = 0.25F * static_cast<float>(quarter);
    list.AddLine(graph.over({0, share}), graph.over({1, share}), theme().line);
    list.AddLine(graph.over({share, 0}), graph.over({share, 1}), theme().line);
  }
  const bool from_start = !profile.empty() && profile.front().along <= 0;
  const bool to_end = !profile.empty() && profile.back().along >= 1;
  std::vector<ImVec2> line;
  if (!from_start) line.push_back(graph.over({0, share_of(profile, 0)}));
  for (const ProfilePoint& point : profile) line.push_back(graph.over(point));
  if (!to_end) line.push_back(graph.over({1, share_of(profile, 1)}));
  for (size_t i = 1; i < line.size(); ++i) {
    const std::array<ImVec2, 4> below{
        {line[i - 1], line[i], {line[i].x, graph.high.y}, {line[i - 1].x, graph.high.y}}};
    list.AddConvexPolyFilled(below.data(), 4, with_alpha(theme().accent_soft, 0.5F));
  }
  list.AddPolyline(line.data(), static_cast<int>(line.size()), theme().accent, ImDrawFlags_None, scaled(2));
  for (size_t i = 0; i < profile.size(); ++i) {
    const ImVec2 at = graph.over(profile[i]);
    const float radius = scaled(hot == i ? kPointSize + 1.5F : kPointSize);
    list.AddCircleFilled(at, radius, hot == i ? theme().accent : theme().text);
  }
}

}  // namespace

CanvasResult profile_canvas(const std::string& name, const WidthProfile& profile, ImVec2 size,
                            CanvasState& state, UiMap& map) {
  const float in = scaled(kInset);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Graph graph{{corner.x + in, corner.y + in}, {corner.x + size.x - in, corner.y + size.y - in}};
  ImGui::InvisibleButton(name.c_str(), size);
  map.mark(name, {graph.low.x, graph.low.y, graph.high.x, graph.high.y});
  CanvasResult result;
  if (const auto before = given_back(state)) state = *before;
  if (ImGui::IsItemActivated()) result = begin_drag(profile, graph, state);
  const ImVec2 mouse = ImGui::IsItemActive() ? drag_place() : ImVec2();
  if (ImGui::IsItemActive() && state.before && !result.pressed) result.changed = go_on(graph, state, mouse);
  if (ImGui::IsItemDeactivated() && state.before) result = end_drag(state);
  const WidthProfile& shown = result.changed ? *result.changed : profile;
  std::optional<size_t> hot = state.dragged;
  if (!state.before && ImGui::IsItemHovered()) hot = point_near(shown, graph, ImGui::GetIO().MousePos);
  draw_graph(shown, graph, hot);
  return result;
}

}  // namespace inkbench
