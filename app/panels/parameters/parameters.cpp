// SPDX-License-Identifier: MIT
#include "app/panels/parameters/parameters.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/panels/parameters/parameter_row.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "app/window/typing_wish.h"
#include "app/window/word_list.h"
#include "app/workbench/group_switches.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

/// "model.rabbit.material" -> "rabbit" and "material"; a group that there is once has its title.
struct Heading {
  std::string name, kind;
};

Heading heading_of(const ParamGroup& group) {
  const std::vector<std::string> parts = split(group.prefix, '.');
  if (parts.size() == 1) return {std::string(group.description->title), ""};
  return {parts[1], parts.back() == parts[1] ? parts[0] : parts.back()};
}

bool draw_heading(UiMap& ui_map, const ParamGroup& group, bool open, bool changed) {
  const Heading heading = heading_of(group);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetFrameHeight() + scaled(2);
  const bool pressed = ImGui::InvisibleButton("heading", {width, height});
  ui_map.mark_item("group:" + group.prefix);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 back = ImGui::IsItemHovered() ? theme().field_hot : theme().bar;
  list.AddRectFilled(low, {low.x + width, low.y + height}, back, ImGui::GetStyle().FrameRounding);
  const float middle = low.y + height / 2;
  const float size = scaled(3.5F);
  const ImVec2 tip{low.x + scaled(11), middle};
  if (open) {
    list.AddTriangleFilled({tip.x - size, tip.y - size / 2}, {tip.x + size, tip.y - size / 2},
                           {tip.x, tip.y + size}, theme().faint);
  } else {
    list.AddTriangleFilled({tip.x - size / 2, tip.y - size}, {tip.x + size, tip.y},
                           {tip.x - size / 2, tip.y + size}, theme().faint);
  }
  const float text_y = middle - ImGui::GetFontSize() / 2;
  float x = low.x + scaled(22);
  x += draw_fitted_text(list, {x, text_y}, width - scaled(40), theme().text, heading.name) + scaled(7);
  if (!heading.kind.empty())
    draw_fitted_text(list, {x, text_y}, low.x + width - x - scaled(18), theme().faint, heading.kind);
  if (changed) list.AddCircleFilled({low.x + width - scaled(10), middle}, scaled(3), theme().accent);
  return pressed;
}

bool is_changed(const ParamGroup& group, const ParamGroup* baseline) {
  if (baseline == nullptr) return false;
  const auto& fields = group.description->fields;
  return std::any_of(fields.begin(), fields.end(), [&](const Field& field) {
    return field.get(group.owner) != field.get(baseline->owner);
  });
}

}  // namespace

bool ParametersPanel::is_found(const std::string& key, const Field& field) const {
  const std::string text = lower_case(key + " " + std::string(field.help));
  const std::vector<std::string> words = split(lower_case(search_), ' ');
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

void ParametersPanel::draw_search() {
  const float button = button_width("Changed");
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
  if (focus_search_) take_keyboard();
  focus_search_ = false;
  ImGui::InputTextWithHint("##search", "Search (Ctrl+F)", &search_, ImGuiInputTextFlags_AutoSelectAll);
  ui_map_.mark_item("search");
  if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) search_.clear();
  ImGui::SameLine();
  if (toggle_button("Changed", only_changed_, "Show only parameters that differ from the scene's file."))
    only_changed_ = !only_changed_;
  ui_map_.mark_item("only changed");
}

/// The group's switches, side by side; the one whose values are set is on.
void ParametersPanel::draw_switches(const Settings& settings, const std::string& group) {
  bool is_first = true;
  for (const GroupSwitch& each : group_switches()) {
    if (each.group != group) continue;
    if (!is_first) ImGui::SameLine();
    is_first = false;
    if (toggle_button(std::string(each.label).c_str(), each.is_on(settings), each.help)) {
      Settings changed = settings;
      each.apply(changed);
      document_.replace(changed, std::string(each.step));
    }
    ui_map_.mark_item("switch:" + std::string(each.label));
  }
}

bool ParametersPanel::draw_group(const Settings& settings, const ParamGroup& group,
                                 const ParamGroup* baseline) {
  const bool searching = !search_.empty() || only_changed_;
  if (!searching && !matters(settings, group)) return false;  // another method's
  std::vector<RowContext> rows;
  for (const Field& field : group.description->fields) {
    RowContext row{group.prefix + "." + std::string(field.name), &field, field.get(group.owner)};
    row.baseline = baseline != nullptr ? field.get(baseline->owner) : row.value;
    row.matters = matters(settings, group, field);
    if (!is_found(row.key, field) || (only_changed_ && row.value == row.baseline)) continue;
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return false;
  ImGui::PushID(group.prefix.c_str());
  const bool was_open = has_word(layout_.open_groups, group.prefix);
  const bool open = searching || was_open;
  if (draw_heading(ui_map_, group, open, is_changed(group, baseline)) && !searching)
    layout_.open_groups = with_word(layout_.open_groups, group.prefix, !was_open);
  if (open) {
    draw_switches(settings, group.prefix);
    const float name_width = std::round(ImGui::GetContentRegionAvail().x * 0.40F);
    for (RowContext& row : rows) {
      row.name_width = name_width;
      parameter_row(document_, view_, studies_, fit_, problems_, ui_map_, row);
    }
    ImGui::Dummy({0, scaled(2)});
  }
  ImGui::PopID();
  return true;
}

void ParametersPanel::draw_nothing_found() {
  const bool searches = !search_.empty();
  wrapped_text(searches ? "No parameter's name or help has \"" + search_ + "\"."
                        : "Nothing differs from " + document_.scene_name() + ".",
               theme().faint);
  if (ImGui::Button("Show all")) {
    search_.clear();
    only_changed_ = false;
  }
}

void ParametersPanel::draw() {
  draw_search();
  ImGui::BeginChild("list", {0, 0}, false, ImGuiWindowFlags_NoBackground);
  Settings settings = document_.settings();  // what is drawn is a copy, changes go through the document
  Settings baseline = document_.baseline();
  const std::vector<ParamGroup> baseline_groups = list_groups(baseline);
  bool any = false;
  for (const ParamGroup& group : list_groups(settings)) {
    const auto same = std::find_if(baseline_groups.begin(), baseline_groups.end(),
                                   [&](const ParamGroup& other) { return other.prefix == group.prefix; });
    any |= draw_group(settings, group, same == baseline_groups.end() ? nullptr : &*same);
  }
  if (!any) draw_nothing_found();
  ImGui::EndChild();
}

}  // namespace inkbench
