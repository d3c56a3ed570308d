// SPDX-License-Identifier: MIT
#include "app/panels/parameters/ramp_strip.h"

#include <algorithm>
#include <cmath>

#include "app/panels/widgets/held_drag.h"
#include "app/window/theme.h"
#include "app/workbench/ramp_edit.h"

namespace inkbench {
namespace {

constexpr float kStripHeight = 34, kHandleHeight = 17, kHandle = 5.5F;
constexpr float kReach = 8;         ///< How near the mouse must be to a stop.
constexpr float kHandleReach = 13;  ///< The same below the strip, where the handles are.
constexpr float kAway = 34;         ///< How far from the strip a stop is dropped.
constexpr float kMoveStarts = 2;    ///< Less is a click.

struct Places {
  ImVec2 low, high;  ///< Of the strip's colours.
  float handle_y = 0;

  float x_of(float position) const { return low.x + position * (high.x - low.x); }
  float position_at(float x) const { return std::clamp((x - low.x) / (high.x - low.x), 0.0F, 1.0F); }
};

ImU32 as_colour(const glm::vec3& c) {
  return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1.0F});
}

std::optional<size_t> stop_near(const Ramp& ramp, const Places& places, ImVec2 mouse, size_t preferred) {
  std::optional<size_t> nearest;
  float least = scaled(mouse.y > places.high.y ? kHandleReach : kReach);
  for (size_t i = 0; i < ramp.stops.size(); ++i) {
    float distance = std::abs(places.x_of(ramp.stops[i].position) - mouse.x);
    if (i == preferred) distance -= 0.5F;  // of two in one place
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

void draw_handle(const Places& places, const RampStop& stop, bool selected) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = std::round(places.x_of(stop.position));
  const float r = scaled(kHandle);
  const ImU32 edge = selected ? theme().accent : theme().text;
  list.AddLine({x, places.low.y}, {x, places.handle_y}, with_alpha(edge, selected ? 1.0F : 0.6F),
               selected ? scaled(2) : 1.0F);
  const float out = scaled(selected ? 2.5F : 1.5F);
  if (stop.stepped) {
    list.AddRectFilled({x - r - out, places.handle_y - r - out}, {x + r + out, places.handle_y + r + out},
                       edge, scaled(2));
    list.AddRectFilled({x - r, places.handle_y - r}, {x + r, places.handle_y + r}, as_colour(stop.colour));
  } else {
    list.AddCircleFilled({x, places.handle_y}, r + out, edge);
    list.AddCircleFilled({x, places.handle_y}, r, as_colour(stop.colour));
  }
}

/// The stop under the mouse, or a new one there.
StripResult press(const Ramp& ramp, const Places& places, StripState& state) {
  StripResult result{.pressed = true};
  const float x = ImGui::GetIO().MousePos.x;
  const std::optional<size_t> near = stop_near(ramp, places, ImGui::GetIO().MousePos, state.selected);
  TouchedRamp touched{ramp, near.value_or(0)};
  if (!near) {
    touched = add_stop(ramp, places.position_at(x));
    result.changed = touched.ramp;
  }
  state.selected = state.dragged = touched.index;
  state.before = touched.ramp;
  state.grip = places.x_of(touched.ramp.stops[touched.index].position) - x;
  state.moved = false;
  result.double_clicked = near && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  return result;
}

std::optional<Ramp> drag(const Places& places, StripState& state, ImVec2 mouse) {
  state.moved |= ImGui::IsMouseDragging(ImGuiMouseButton_Left, kMoveStarts);
  if (!state.moved) return std::nullopt;
  const Ramp& before = *state.before;
  const float far = scaled(kAway);
  if (before.stops.size() > 1 && (mouse.y < places.low.y - far || mouse.y > places.handle_y + far)) {
    state.selected = state.dragged > 0 ? state.dragged - 1 : 0;
    return remove_stop(before, state.dragged);
  }
  const TouchedRamp touched = move_stop(before, state.dragged, places.position_at(mouse.x + state.grip));
  state.selected = touched.index;
  return touched.ramp;
}

void show_cursor(const Ramp& ramp, const Places& places, const StripState& state) {
  const float x = ImGui::GetIO().MousePos.x;
  if (stop_near(ramp, places, ImGui::GetIO().MousePos, state.selected)) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  } else if (!state.before) {
    ImGui::GetWindowDrawList()->AddLine({x, places.low.y}, {x, places.high.y},
                                        with_alpha(theme().accent, 0.8F));
  }
}

}  // namespace

void draw_ramp_colours(ImDrawList& list, ImVec2 low, ImVec2 high, std::span<const glm::vec3> colours) {
  const float width = high.x - low.x;
  const auto colour_at = [&](float x) {
    const auto i = static_cast<size_t>((x + 0.5F) / width * static_cast<float>(colours.size()));
    return as_colour(colours[std::min(i, colours.size() - 1)]);
  };
  float from = 0;
  for (float x = 1; x <= width && !colours.empty(); ++x) {
    if (x + 1 <= width && colour_at(x) == colour_at(from)) continue;
    list.AddRectFilled({low.x + from, low.y}, {low.x + x, high.y}, colour_at(from));
    from = x;
  }
}

StripResult ramp_strip_editor(const std::string& name, const Ramp& ramp, std::span<const glm::vec3> colours,
                              float width, StripState& state, UiMap& map) {
  const float in = scaled(kHandle + 3);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Places places{{corner.x + in, corner.y},
                      {corner.x + width - in, corner.y + scaled(kStripHeight)},
                      corner.y + scaled(kStripHeight + kHandleHeight / 2 + 2)};
  ImGui::InvisibleButton(name.c_str(), {width, scaled(kStripHeight + kHandleHeight)});
  map.mark(name, {places.low.x, places.low.y, places.high.x, places.high.y});
  StripResult result;
  const bool has_stops = ramp.image.empty() && !ramp.stops.empty();
  if (const auto before = given_back(state)) state = *before;
  if (has_stops && ImGui::IsItemActivated()) result = press(ramp, places, state);
  const ImVec2 mouse = ImGui::IsItemActive() ? drag_place() : ImVec2();
  if (ImGui::IsItemActive() && state.before && !result.pressed) result.changed = drag(places, state, mouse);
  if (ImGui::IsItemDeactivated() && state.before) {
    state.before.reset();
    result.released = true;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_ramp_colours(list, places.low, places.high, colours);
  list.AddRect({places.low.x - 1, places.low.y - 1}, {places.high.x + 1, places.high.y + 1}, theme().line);
  const Ramp& shown = result.changed ? *result.changed : ramp;
  if (!has_stops) return result;
  for (size_t i = 0; i < shown.stops.size(); ++i) {
    if (i != state.selected) draw_handle(places, shown.stops[i], false);
  }
  state.selected = std::min(state.selected, shown.stops.size() - 1);
  draw_handle(places, shown.stops[state.selected], true);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) show_cursor(shown, places, state);
  return result;
}

}  // namespace inkbench
