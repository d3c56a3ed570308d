// SPDX-License-Identifier: MIT
#include "app/panels/study/study_axes.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/value_bar.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "app/window/typing_wish.h"
#include "pipeline/base/text.h"
#include "studies/sweep/labels.h"

namespace inkbench {
namespace {

constexpr std::array kPlaces{"Columns", "Rows", "Pages"};
constexpr int kMostCount = 1000;

/// The number of steps, which no parameter is.
const Field& count_field() {
  static const Field kField = [] {
    Field field{{.name = "count", .help = "Values.", .limits = {1, kMostCount}, .slider = {2, 25}}};
    field.type = FieldType::integer;
    return field;
  }();
  return kField;
}

/// 0.003 and not the float nearest to it.
double decimal(double value) {
  return std::strtod(shortest(static_cast<float>(value)).c_str(), nullptr);
}

void end_bar(UiMap& ui_map, const std::string& id, const char* help, const Field& field, double& value,
             float width) {
  const BarResult bar = value_bar(id.c_str(), value, field, width);
  const double next = bar.given_up ? bar.value : entered(bar).value_or(value);
  if (next != value) value = field.type == FieldType::integer ? std::round(next) : decimal(next);
  ui_map.mark_item(id);
  help_for_item(help);
}

void scale_choice(UiMap& ui_map, SweepAxis& axis, const std::string& id) {
  const bool log = axis.scale == Scale::log;
  if (toggle_button("Log", log, "Each value is a multiple of the one before.")) axis.scale = Scale::log;
  ui_map.mark_item(id + " log");
  ImGui::SameLine(0, 2);
  if (toggle_button("Linear", !log, "Equal steps.")) axis.scale = Scale::linear;
  ui_map.mark_item(id + " linear");
}

void range_editor(UiMap& ui_map, SweepAxis& axis, const Field& field, const std::string& id) {
  const float gap = scaled(4);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float scale_width = ImGui::CalcTextSize("LogLinear").x + 4 * style.FramePadding.x + 2 +
                            ImGui::CalcTextSize("in").x + 3 * gap;
  const float room = ImGui::GetContentRegionAvail().x - scale_width - 2 * gap - ImGui::CalcTextSize("to").x;
  const float width = std::floor((room - scaled(52)) / 2);
  end_bar(ui_map, id + " from", "The first value.", field, axis.from, width);
  ImGui::SameLine(0, gap);
  ImGui::AlignTextToFramePadding();
  faint_text("to");
  ImGui::SameLine(0, gap);
  end_bar(ui_map, id + " to", "The last value.", field, axis.to, width);
  ImGui::SameLine(0, gap);
  faint_text("in");
  ImGui::SameLine(0, gap);
  double count = axis.count;
  end_bar(ui_map, id + " count", "How many values.", count_field(), count, scaled(48));
  axis.count = static_cast<int>(std::clamp(count, 1.0, static_cast<double>(kMostCount)));
  ImGui::SameLine(0, gap);
  scale_choice(ui_map, axis, id);
}

/// All values of a choice, each to be taken or not; one stays.
void values_editor(UiMap& ui_map, SweepAxis& axis, const Field& field, const std::string& id) {
  std::vector<Value> all;
  if (field.type == FieldType::boolean) all = {Value(false), Value(true)};
  for (const std::string_view choice : field.choices) all.emplace_back(std::string(choice));
  for (size_t i = 0; i < all.size(); ++i) {
    const auto place = std::find(axis.values.begin(), axis.values.end(), all[i]);
    const bool on = place != axis.values.end();
    const std::string text = label_text(all[i]);
    const float width = button_width(text.c_str());
    if (i > 0) ImGui::SameLine(0, scaled(4));
    if (i > 0 && ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    if (toggle_button(text.c_str(), on)) {
      std::vector<Value> next;
      for (const Value& value : all) {
        const bool had = std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end();
        if (had != (value == all[i])) next.push_back(value);
      }
      if (!next.empty()) axis.values = next;
    }
    ui_map.mark_item(id + "=" + text);
  }
}

std::string values_text(const CheckedForm& checked, const std::string& key) {
  if (!checked.spec) return "";
  constexpr size_t kShown = 40;
  for (const Axis& axis : checked.spec->axes) {
    if (axis.key != key) continue;
    std::vector<std::string> texts;
    for (size_t i = 0; i < std::min(axis.values.size(), kShown); ++i)
      texts.push_back(label_text(axis.values[i]));
    return join(texts, "   ");
  }
  return "";
}

/// Returns whether the axis is to go.
bool axis_head(UiMap& ui_map, const SweepAxis& axis, size_t index, bool can_turn) {
  faint_text(kPlaces[std::min(index, kPlaces.size() - 1)]);
  ImGui::SameLine(scaled(66));
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(axis.key.c_str());
  ImGui::PopFont();
  const float width = button_width("✕");
  ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - width, scaled(80)));
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  const bool gone = ImGui::SmallButton("✕");
  ImGui::PopStyleColor();
  ui_map.mark_item("remove axis " + std::to_string(index));
  help_for_item(can_turn ? "Take this axis off; the next one takes its place." : "Take this axis off.");
  return gone;
}

void add_axis_combo(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map,
                    const StudyForm& form) {
  static std::string search;
  const bool first = form.request.axes.empty();
  ImGui::SetNextItemWidth(first ? -1 : scaled(190));
  const bool open = ImGui::BeginCombo("##add axis", first ? "Choose a parameter to sweep" : "Add a parameter",
                                      ImGuiComboFlags_HeightLarge);
  ui_map.mark_item("add axis");
  if (!open) return;
  if (ImGui::IsWindowAppearing()) {
    search.clear();
    take_keyboard();
  }
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##find", "Search", &search);
  for (const std::string& key : sweepable_keys(document.settings())) {
    const auto taken = std::any_of(form.request.axes.begin(), form.request.axes.end(),
                                   [&](const SweepAxis& axis) { return axis.key == key; });
    if (taken || key.find(search) == std::string::npos) continue;
    if (ImGui::Selectable(key.c_str()))
      attempt(problems, [&] { studies.add_axis(document.settings(), key); });
    ui_map.mark_item("axis:" + key);
  }
  ImGui::EndCombo();
}

}  // namespace

void draw_study_axes(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map,
                     StudyForm& form, const CheckedForm& checked) {
  std::vector<SweepAxis>& axes = form.request.axes;
  const Settings& settings = document.settings();
  std::optional<size_t> gone;
  for (size_t i = 0; i < axes.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const std::string id = "axis " + std::to_string(i);
    if (axis_head(ui_map, axes[i], i, i + 1 < axes.size())) gone = i;
    if (has_param(settings, axes[i].key)) {
      const Field& field = *find_param(settings, axes[i].key, "").field;
      if (axes[i].values.empty()) {
        range_editor(ui_map, axes[i], field, id);
        fitted_text(values_text(checked, axes[i].key), ImGui::GetContentRegionAvail().x, theme().faint);
      } else {
        values_editor(ui_map, axes[i], field, id);
      }
    }
    ImGui::Dummy({0, scaled(4)});
    ImGui::PopID();
  }
  if (gone) axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(*gone));
  if (axes.size() < kPlaces.size()) add_axis_combo(document, studies, problems, ui_map, form);
}

}  // namespace inkbench
