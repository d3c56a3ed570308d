// SPDX-License-Identifier: MIT
#include "app/panels/widgets/value_bar.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/panels/widgets/held_drag.h"
#include "app/window/theme.h"
#include "app/window/typing_wish.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

/// The one number that is being typed, if any.
struct Typing {
  ImGuiID id = 0;
  std::string text;
  bool focus = false;
  bool passes_on = false;  ///< Tab was pressed: the next bar is typed into.
};

Typing& typing() {
  static Typing value;
  return value;
}

double rounded_to(double value, double step) {
  return std::round(value / step) * step;
}

/// The power of ten that is at most a two-hundredth of the range.
double linear_step(const Limits& range) {
  return std::pow(10.0, std::floor(std::log10((range.high - range.low) / 200.0)));
}

double log_step(double value) {
  return std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
}

bool is_log(const Field& field) {
  return field.scale == Scale::log && field.slider.low > 0.0;
}

/// A text field in the bar's place; true when it is done, confirmed or not.
bool type_number(float width, BarResult& result) {
  Typing& state = typing();
  ImGui::SetNextItemWidth(width);
  if (state.focus) take_keyboard();
  state.focus = false;
  const bool confirmed = ImGui::InputText(
      "##typed", &state.text, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  const bool tab = ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab), false);
  const bool left = ImGui::IsItemDeactivated() || tab;
  const bool cancelled = left && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if ((confirmed || left) && !cancelled) result.typed = state.text;
  if (tab) ImGui::ClearActiveID();
  state.passes_on = tab;
  if (tab) expect_typing();
  return confirmed || left;
}

/// Where on the bar it is dragged to. With Shift the value goes on from where it is; else it jumps to the
/// mouse.
double dragged_share(const Field& field, double value, ImVec2 low, float width) {
  static float grip = 0;  // from the mouse to the value, in pixels
  const float x = drag_place().x;
  if (ImGui::IsItemActivated()) {
    const bool stays = ImGui::GetIO().KeyShift;
    grip = stays ? low.x + static_cast<float>(share_of(field, value)) * width - x : 0.0F;
  }
  return (x + grip - low.x) / width;
}

/// Between the values that were looked at it changes evenly; what is equally good is underlined.
void draw_heat(ImVec2 low, ImVec2 high, const Field& field, const ValueHeat& heat) {
  constexpr float kMostHeat = 0.5F;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto x_of = [&](double value) {
    return low.x + static_cast<float>(share_of(field, value)) * (high.x - low.x);
  };
  const auto glow = [](const ValueHeat::Point& point) {
    return ImGui::GetColorU32(with_alpha(theme().good, kMostHeat * static_cast<float>(point.warmth)));
  };
  for (size_t i = 1; i < heat.points.size(); ++i) {
    const ImU32 left = glow(heat.points[i - 1]), right = glow(heat.points[i]);
    list.AddRectFilledMultiColor({x_of(heat.points[i - 1].value), low.y},
                                 {x_of(heat.points[i].value), high.y}, left, right, right, left);
  }
  if (!heat.equally_good) return;
  const auto [from, to] = *heat.equally_good;
  list.AddRectFilled({x_of(from) - 1, high.y - scaled(2)}, {x_of(to) + 1, high.y},
                     ImGui::GetColorU32(theme().good));
}

void draw_bar(ImVec2 low, ImVec2 high, const Field& field, double value, bool hot, const ValueHeat* heat) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const auto colour = [](ImU32 c) { return ImGui::GetColorU32(c); };
  list.AddRectFilled(low, high, colour(hot ? theme().field_hot : theme().field), rounding);
  const bool named = value == 0.0 && !field.zero_text.empty();
  const auto share = named ? 1.0F : static_cast<float>(share_of(field, value));
  const float edge = low.x + share * (high.x - low.x);
  list.PushClipRect(low, {edge, high.y}, true);
  list.AddRectFilled(low, high, colour(theme().accent_soft), rounding);
  list.PopClipRect();
  if (heat != nullptr) draw_heat(low, high, field, *heat);
  if (hot) list.AddLine({edge, low.y + 1}, {edge, high.y - 1}, colour(theme().accent), scaled(2));
  const std::string text =
      named ? std::string(field.zero_text) : number_text(value, field.type == FieldType::integer);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 place{std::round(low.x + (high.x - low.x - size.x) / 2),
                     low.y + (high.y - low.y - size.y) / 2};
  list.AddText(place, colour(theme().text), text.c_str());
}

}  // namespace

std::optional<double> entered(const BarResult& bar) {
  if (bar.dragged) return bar.value;
  char* end = nullptr;
  const double typed = std::strtod(bar.typed.c_str(), &end);
  if (end == bar.typed.c_str() || !std::isfinite(typed)) return std::nullopt;
  return typed;
}

std::string number_text(double value, bool whole) {
  if (whole) return with_commas(std::llround(value));
  const std::string exact = shortest(static_cast<float>(value));
  return exact.size() <= 7 ? exact : fmt::format("{:.4g}", value);
}

double share_of(const Field& field, double value) {
  const auto [low, high] = field.slider;
  if (!(high > low)) return 0.0;
  const double share = is_log(field) ? std::log(std::max(value, low) / low) / std::log(high / low)
                                     : (value - low) / (high - low);
  return std::clamp(share, 0.0, 1.0);
}

double value_at(const Field& field, double share, bool fine) {
  const auto [low, high] = field.slider;
  share = std::clamp(share, 0.0, 1.0);
  double value = is_log(field) ? low * std::pow(high / low, share) : low + share * (high - low);
  double step = is_log(field) ? log_step(value) : linear_step(field.slider);
  if (fine) step /= 10.0;
  if (field.type == FieldType::integer) step = std::max(1.0, step);
  if (share > 0.0 && share < 1.0) value = rounded_to(value, step);
  return std::clamp(value, low, high);
}

BarResult value_bar(const char* id, double value, const Field& field, float width, const ValueHeat* heat) {
  BarResult result;
  ImGui::PushID(id);
  const ImGuiID own = ImGui::GetID("bar");
  if (typing().id == own) {
    if (type_number(width, result)) typing() = {.passes_on = typing().passes_on};
    ImGui::PopID();
    return result;
  }
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high{low.x + width, low.y + ImGui::GetFrameHeight()};
  ImGui::InvisibleButton("bar", {std::max(width, 1.0F), high.y - low.y});
  const ImGuiIO& io = ImGui::GetIO();
  const bool wants_typing =
      (ImGui::IsItemClicked() && io.KeyCtrl) || std::exchange(typing().passes_on, false);
  if (wants_typing) {
    const bool whole = field.type == FieldType::integer;
    typing() = {own, whole ? fmt::format("{:.0f}", value) : shortest(static_cast<float>(value)), true};
    expect_typing();
  }
  if (const auto before = given_back(value)) {
    result.given_up = true;
    result.value = *before;
  }
  const bool dragging = ImGui::IsItemActive() && !wants_typing && !io.KeyCtrl;
  result.pressed = ImGui::IsItemActivated() && !wants_typing;
  result.released = ImGui::IsItemDeactivated();
  result.reset = ImGui::IsItemClicked(ImGuiMouseButton_Right);
  const double share = ImGui::IsItemActive() ? dragged_share(field, value, low, high.x - low.x) : 0.0;
  if (dragging) {
    const bool moved = io.MouseDelta.x != 0.0F || (ImGui::IsItemActivated() && !io.KeyShift);
    if (moved) result.value = value_at(field, share, io.KeyShift);
    result.dragged = moved && result.value != value;
  }
  draw_bar(low, high, field, value, ImGui::IsItemHovered() || ImGui::IsItemActive(), heat);
  ImGui::PopID();
  return result;
}

}  // namespace inkbench
