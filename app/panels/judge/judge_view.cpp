// SPDX-License-Identifier: MIT
#include "app/panels/judge/judge_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/panels/pictures/overlay_legend.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/pictures.h"
#include "app/window/theme.h"
#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/lines/drawing.h"

namespace inkbench {
namespace {

/// Shorter waits are not worth a word.
constexpr double kPatience = 0.4;

std::string value_text(const std::optional<double>& value, bool is_count) {
  if (!value) return "–";
  return is_count ? with_commas(std::llround(*value)) : fmt::format("{:.3f}", *value);
}

/// "" where the change would read as none.
std::string change_text(const std::optional<double>& now, const std::optional<double>& then, bool is_count) {
  if (!now || !then) return "";
  const double change = *now - *then;
  if (std::abs(change) < (is_count ? 0.5 : 0.0005)) return "";
  return is_count ? fmt::format("{:+.0f}", change) : fmt::format("{:+.3f}", change);
}

void text_at_right(std::string_view text, float right, ImU32 colour) {
  const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
  const ImVec2 place = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddText({right - size.x, place.y}, colour, text.data(),
                                      text.data() + text.size());
}

/// A measure with its values now and when the state was pinned.
struct Row {
  const Measure& measure;
  std::optional<double> now, then;

  bool is_count() const { return measure.kind == MeasureKind::count; }
  /// Below the heading of the classes, a class's own name.
  std::string_view name() const { return measure.line_class ? name_of(*measure.line_class) : measure.key; }
};

/// Good news, bad news or neither.
ImU32 change_colour(const Row& row) {
  if (row.measure.better == Better::neither || *row.now == *row.then) return theme().faint;
  return (*row.now > *row.then) == (row.measure.better == Better::more) ? theme().good : theme().error;
}

float change_width() {
  return ImGui::CalcTextSize("+0.0000").x;
}

void draw_change(const Row& row, float right) {
  const std::string change = change_text(row.now, row.then, row.is_count());
  text_at_right(change, right, change.empty() ? theme().faint : change_colour(row));
}

/// Name, value and change; the columns of all rows line up.
void draw_row(const Row& row, bool compares) {
  const float left = ImGui::GetCursorScreenPos().x;
  const float right = left + ImGui::GetContentRegionAvail().x;
  const float value_right = compares ? right - change_width() : right;
  const std::string value = value_text(row.now, row.is_count());
  text_at_right(value, value_right, row.now ? theme().text : theme().faint);
  if (compares) draw_change(row, right);
  const float room = value_right - left - ImGui::CalcTextSize(value.c_str()).x - scaled(8);
  const ImVec2 place = ImGui::GetCursorScreenPos();
  ImGui::Dummy({right - left, ImGui::GetTextLineHeight()});
  help_for_item(row.measure.help);
  draw_fitted_text(*ImGui::GetWindowDrawList(), place, room, theme().faint, row.name());
}

void draw_bar(const Row& row, ImU32 colour) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = scaled(4);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = low.y - scaled(2);
  list.AddRectFilled({low.x, top}, {low.x + width, top + height}, theme().field, height / 2);
  const auto x_of = [&](double share) {
    return low.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * width;
  };
  if (row.now) list.AddRectFilled({low.x, top}, {x_of(*row.now), top + height}, colour, height / 2);
  if (row.then)
    list.AddLine({x_of(*row.then), top - 2}, {x_of(*row.then), top + height + 2}, theme().text, scaled(1.5F));
  ImGui::Dummy({width, height});
}

void heading(const char* text) {
  ImGui::Dummy({0, scaled(4)});
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

Row row_of(const Measure& measure, const Judgement& now, const Judgement* then) {
  Row row{measure, measure.value(now.tally), std::nullopt};
  if (then != nullptr) row.then = measure.value(then->tally);
  return row;
}

/// As bars above the others.
void draw_headlines(const Judgement& now, const Judgement* then) {
  for (const Measure& measure : measure_table()) {
    if (!measure.is_headline) continue;
    const Row row = row_of(measure, now, then);
    draw_row(row, then != nullptr);
    draw_bar(row, theme().accent);
  }
}

ImU32 class_colour(LineClass line_class) {
  const std::array<uint8_t, 3> c = colour_of(line_class);
  return IM_COL32(c[0], c[1], c[2], 255);
}

void draw_swatch(ImU32 colour) {
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float size = scaled(9);
  const float top = place.y + (ImGui::GetTextLineHeight() - size) / 2 + 1;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({place.x, top}, {place.x + size, top + size}, colour);
  list.AddRect({place.x, top}, {place.x + size, top + size}, theme().faint);
  ImGui::SetCursorScreenPos({place.x + size + scaled(7), place.y});
}

/// Only classes that the view has lines of, now or when it was pinned.
void draw_recall(const Judgement& now, const Judgement* then) {
  heading("Recall by class");
  for (const Measure& measure : measure_table()) {
    if (measure.needs != Need::reference_class) continue;
    const Row row = row_of(measure, now, then);
    if (!row.now && !row.then) continue;
    draw_swatch(class_colour(*measure.line_class));
    draw_row(row, then != nullptr);
  }
}

/// Of a level of the mesh: which part of a loss is the geometry's. While the full mesh's lines are being
/// found the rows stay.
void draw_ladder(const Viewer& viewer, const Judgement& now, const Judgement* then) {
  if (!viewer.drawn() || viewer.drawn()->settings().mesh == MeshParams{}) return;
  heading("Against the full mesh");
  for (const Measure& measure : measure_table()) {
    if (measure.of_level()) draw_row(row_of(measure, now, then), then != nullptr);
  }
}

void draw_others(const Judgement& now, const Judgement* then) {
  heading("All measures");
  for (const Measure& measure : measure_table()) {
    const bool is_above = measure.is_headline || measure.needs == Need::reference_class || measure.of_level();
    if (is_above || measure.of_path() || measure.of_marks() || measure.needs == Need::nothing ||
        measure.kind == MeasureKind::flag)
      continue;
    draw_row(row_of(measure, now, then), then != nullptr);
  }
}

/// Whether the pinned state shows the same models, at any level, from the same camera.
bool is_same_view(const Document& document, const Pictures& pictures) {
  const auto view_text = [](const Settings& settings) {
    std::string text = group_text(settings.camera) + group_text(settings.image);
    for (const ModelParams& model : settings.models) text += group_text(model);
    return text;
  };
  const std::optional<Settings>& pinned = pictures.pinned_settings();
  return pinned && view_text(*pinned) == view_text(document.settings());
}

}  // namespace

void JudgeView::draw_state() {
  pin_compares_ = viewer_.judge.pinned() != nullptr && is_same_view(document_, viewer_.pictures);
  const JudgeDesk& judge = viewer_.judge;
  const double time = ImGui::GetTime();
  if (!judge.is_behind()) behind_since_ = -1.0;
  if (judge.is_behind() && behind_since_ < 0.0) behind_since_ = time;
  const bool waits = behind_since_ >= 0.0 && (time - behind_since_ > kPatience || judge.now() == nullptr);
  if (judge.is_behind() && !waits) requests_.wake_in(kPatience);
  std::string text;
  if (judge.now() != nullptr)
    text = fmt::format("{}{:.0f} ms", judge.pinned() == nullptr ? "measured in " : "",
                       1e3 * judge.now()->seconds);
  if (waits) {
    text = "measuring…";
  } else if (judge.pinned() != nullptr) {
    text += pin_compares_ ? ", changes since the pin" : ", the pin is of another view";
  }
  fitted_text(text, ImGui::GetContentRegionAvail().x, theme().faint);
  ImGui::Dummy({0, scaled(1)});
}

void JudgeView::draw() {
  overlay_choice(layout_, ui_map_);
  fit_.draw();
  draw_state();
  const Judgement* now = viewer_.judge.now();
  const Judgement* then = viewer_.judge.pinned();
  if (now == nullptr) return;
  if (!now->error.empty()) {
    wrapped_text(now->error, theme().error);
    return;
  }
  if (now->tally.lines.empty()) {
    wrapped_text("Neither a drawn line nor a reference line is in sight: there is nothing to judge.",
                 theme().faint);
    return;
  }
  const bool compares = pin_compares_ && then != nullptr && then->error.empty() && !then->tally.lines.empty();
  if (!compares) then = nullptr;
  draw_headlines(*now, then);
  draw_ladder(viewer_, *now, then);
  draw_recall(*now, then);
  draw_others(*now, then);
}

}  // namespace inkbench
