// SPDX-License-Identifier: MIT
#include "app/panels/pictures/histogram_view.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

#include "app/panels/widgets/held_drag.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr int kBins = 128;
constexpr float kHeight = 62, kReach = 7;
constexpr float kLimits = 4;     ///< Strengths, which have no upper end, are shown up to so many limits.
constexpr double kLongMs = 6.0;  ///< Longer ones wait until nothing is dragged.

void draw_channel(ImVec2 low, ImVec2 high, const ValueHistogram& histogram, size_t channel, float from,
                  float to, ImU32 colour, bool log) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int64_t largest = histogram.largest();
  const std::vector<int64_t>& counts = histogram.channels[channel];
  const float width = (to - from) / static_cast<float>(counts.size());
  for (size_t i = 0; i < counts.size(); ++i) {
    const float share = bar_height(counts[i], largest, log);
    if (share <= 0) continue;
    const float x = from + static_cast<float>(i) * width;
    const float top = high.y - std::max(share * (high.y - low.y - 3), 1.0F);
    list.AddRectFilled({x, top}, {std::max(x + width, x + 1), high.y}, colour);
  }
}

void draw_mark_at(float x, ImVec2 low, ImVec2 high, ImU32 fill, bool hot) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = scaled(5);
  list.AddLine({x, low.y}, {x, high.y}, theme().accent, scaled(hot ? 2 : 1));
  const ImVec2 left{x - r, high.y + 1.7F * r};
  const ImVec2 right{x + r, high.y + 1.7F * r};
  list.AddTriangleFilled({x, high.y + 1}, right, left, fill);
  list.AddTriangle({x, high.y + 1}, right, left, hot ? theme().accent : theme().text, scaled(1.5F));
}

}  // namespace

ShownRange shown_range(const Document& document, Pictures& pictures, BufferName buffer) {
  const PictureChoice& choice = pictures.choice(buffer);
  if (choice.kind == PictureChoice::Kind::fixed) return choice.fixed;
  const ShownPicture& shown = pictures.shown(buffer, false);
  if (choice.kind == PictureChoice::Kind::fitted && shown.range) return *shown.range;
  return gain_range(document.settings().display, buffer);
}

/// Of what is drawn; where that takes long, after a drag only.
void HistogramView::refresh(const Frame& drawn, BufferName buffer) {
  const Key key = KeyBuilder().add(name_of(buffer)).add(drawn.key(buffer)).key();
  if (key == key_) return;
  const bool same = buffer == buffer_ && !histogram_.channels.empty();
  if (same && document_.is_editing() && took_ms_ > kLongMs) return;
  const auto start = std::chrono::steady_clock::now();
  const float limit = buffer.info().limit;
  histogram_ = limit > 0 ? histogram_of(drawn.raw(buffer), kBins, kLimits * limit)
                         : histogram_of(drawn.raw(buffer), kBins);
  took_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  key_ = key;
  buffer_ = buffer;
}

void HistogramView::drag_marks(BufferName buffer, const ShownRange& range, ImVec2 low, ImVec2 high) {
  if (const auto before = given_back(viewer_.pictures.choice(buffer)))
    viewer_.pictures.choice(buffer) = *before;
  const float mouse = ImGui::IsItemActive() ? drag_place().x : ImGui::GetIO().MousePos.x;
  const auto x_of = [&](float value) {
    return low.x + (value - axis_.low) / (axis_.high - axis_.low) * (high.x - low.x);
  };
  const float to_black = std::abs(x_of(range.black) - mouse);
  const float to_white = std::abs(x_of(range.white) - mouse);
  const int nearest = to_black < to_white ? 0 : 1;
  const bool near = std::min(to_black, to_white) < scaled(kReach);
  if ((ImGui::IsItemHovered() && near) || dragged_ >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActivated() && near) dragged_ = nearest;
  if (ImGui::IsItemActive() && dragged_ >= 0 && ImGui::GetIO().MouseDelta.x != 0.0F) {
    const float value =
        axis_.low + std::clamp((mouse - low.x) / (high.x - low.x), 0.0F, 1.0F) * (axis_.high - axis_.low);
    const float least = (axis_.high - axis_.low) * 1e-3F;
    PictureChoice& choice = viewer_.pictures.choice(buffer);
    choice = {PictureChoice::Kind::fixed, range};
    if (dragged_ == 0) choice.fixed.black = std::min(value, range.white - least);
    if (dragged_ == 1) choice.fixed.white = std::max(value, range.black + least);
  }
  if (!ImGui::IsItemActive()) dragged_ = -1;
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    viewer_.pictures.choice(buffer).kind = PictureChoice::Kind::gains;
}

/// What is typed is taken; the other value makes room for it.
void HistogramView::draw_fields(BufferName buffer, const ShownRange& range) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float labels = ImGui::CalcTextSize("black").x + ImGui::CalcTextSize("white").x;
  const float room = ImGui::GetContentRegionAvail().x - labels - button_width("log") - 4 * gap;
  const auto field = [&](const char* name, float value) -> std::optional<float> {
    ImGui::AlignTextToFramePadding();
    faint_text(name);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(room / 2);
    ImGui::PushID(name);
    const bool entered =
        ImGui::InputFloat("##value", &value, 0, 0, "%g", ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopID();
    ui_map_.mark_item(std::string("range:") + name);
    ImGui::SameLine();
    return entered && std::isfinite(value) ? std::optional(value) : std::nullopt;
  };
  const auto least = [&](float value) {
    return std::max((axis_.high - axis_.low) * 1e-3F, std::abs(value) * 1e-4F);
  };
  PictureChoice& choice = viewer_.pictures.choice(buffer);
  if (const std::optional<float> black = field("black", range.black))
    choice = {PictureChoice::Kind::fixed, {*black, std::max(range.white, *black + least(*black))}};
  if (const std::optional<float> white = field("white", range.white))
    choice = {PictureChoice::Kind::fixed, {std::min(range.black, *white - least(*white)), *white}};
}

void HistogramView::draw(BufferName buffer) {
  if (!viewer_.drawn()) return;
  try {
    refresh(*viewer_.drawn(), buffer);
  } catch (const Error&) {
    return;  // told by the banner
  }
  const ShownRange range = shown_range(document_, viewer_.pictures, buffer);
  if (dragged_ < 0) axis_ = {std::min(histogram_.low, range.black), std::max(histogram_.high, range.white)};
  if (!(axis_.low < axis_.high)) axis_.high = axis_.low + 1.0F;
  const float in = scaled(5);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 low{corner.x + in, corner.y};
  const ImVec2 high{corner.x + width - in, corner.y + scaled(kHeight)};
  ImGui::InvisibleButton("histogram", {width, scaled(kHeight + 11)});
  const auto x_of = [&](float value) {
    return low.x + (value - axis_.low) / (axis_.high - axis_.low) * (high.x - low.x);
  };
  const auto mark = [&](const char* name, float from, float to) {
    if (ImGui::IsItemVisible()) ui_map_.mark(name, {from, low.y, to, high.y});
  };
  mark("histogram", low.x, high.x);
  mark("mark:black", x_of(range.black) - 2, x_of(range.black) + 2);
  mark("mark:white", x_of(range.white) - 2, x_of(range.white) + 2);
  drag_marks(buffer, range, low, high);
  const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, theme().field, scaled(2));
  constexpr std::array kColours{IM_COL32(220, 90, 80, 150), IM_COL32(90, 180, 90, 150),
                                IM_COL32(80, 130, 230, 150)};
  const bool grey = histogram_.channels.size() == 1;
  for (size_t c = 0; c < histogram_.channels.size(); ++c)
    draw_channel(low, high, histogram_, c, x_of(histogram_.low), x_of(histogram_.high),
                 grey ? theme().faint : kColours[c % 3], log_);
  if (const float limit = buffer.info().limit; limit > axis_.low && limit < axis_.high) {
    const float x = std::round(x_of(limit));
    list.AddLine({x, low.y}, {x, high.y}, theme().text, scaled(1));
    list.AddText({x + scaled(3), low.y}, theme().text, "limit");
    mark("mark:limit", x - 1, x + 1);
  }
  draw_mark_at(std::round(x_of(range.black)), low, high, IM_COL32(0, 0, 0, 255), hot);
  draw_mark_at(std::round(x_of(range.white)), low, high, IM_COL32(255, 255, 255, 255), hot);
  if (dragged_ < 0)
    help_for_item(
        "How often each value occurs. Drag the marks to choose what is shown as black and as white; "
        "double click for the display gains again.");
  draw_fields(buffer, range);
  if (toggle_button("log", log_, "Bars by the logarithm of how often.")) log_ = !log_;
  ui_map_.mark_item("histogram log");
}

}  // namespace inkbench
