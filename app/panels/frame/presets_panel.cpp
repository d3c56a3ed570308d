// SPDX-License-Identifier: MIT
#include "app/panels/frame/presets_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "app/workbench/scene_base.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr int kListEveryFrames = 60;

std::string cell_text(const std::optional<Value>& value) {
  if (!value) return "none";
  std::string text = to_text(*value);
  if (const auto* ramp = std::get_if<Ramp>(&*value); ramp != nullptr && text.size() > 24)
    text = ramp->image.empty() ? std::to_string(ramp->stops.size()) + " stops" : ramp->image;
  return text;
}

}  // namespace

void PresetsPanel::list_again() {
  names_ = keeping_.presets().list();
  frames_to_listing_ = kListEveryFrames;
  if (std::find(names_.begin(), names_.end(), selected_) != names_.end()) return;
  selected_.clear();
  settings_.reset();
  question_ = Question::none;
}

void PresetsPanel::select(const std::string& name) {
  selected_ = name;
  settings_.reset();
  fault_.clear();
  question_ = Question::none;
  compared_revision_ = -1;
  try {
    settings_ = keeping_.presets().load(name);
  } catch (const Error& error) {
    fault_ = error.what();
  }
}

void PresetsPanel::save(const std::string& name, bool overwrite) {
  const bool saved = attempt(problems_, [&] {
    const PresetStore& presets = keeping_.presets();
    presets.save(name, with_absolute_paths(document_.settings()), overwrite, document_.marks());
    keeping_.add_recent(presets.path_of(name));
    problems_.tell(Severity::note, "saved the preset " + name);
  });
  if (saved) name_.clear();
  list_again();
  if (keeping_.presets().contains(name)) select(name);
}

void PresetsPanel::remove() {
  attempt(problems_, [&] {
    keeping_.presets().remove(selected_);
    problems_.tell(Severity::note, "deleted the preset " + selected_);
  });
  list_again();
}

void PresetsPanel::draw_saving() {
  const float button = button_width("Save");
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
  const bool entered = ImGui::InputTextWithHint("##name", "Name of a new preset", &name_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  ui_map_.mark_item("preset:name");
  ImGui::SameLine();
  ImGui::BeginDisabled(name_.empty());
  const bool pressed = ImGui::Button("Save");
  ui_map_.mark_item("preset:save");
  ImGui::EndDisabled();
  if ((entered || pressed) && !name_.empty()) save(std::string(name_), false);
}

void PresetsPanel::draw_list(float height) {
  ImGui::BeginChild("presets", {0, height}, false, ImGuiWindowFlags_NoBackground);
  if (names_.empty()) {
    wrapped_text("No presets yet. A preset keeps all settings under a name.", theme().faint);
  }
  const std::vector<std::string> names = names_;  // a double click loads, which lists again
  for (const std::string& name : names) {
    const bool is_scene = document_.scene() == keeping_.presets().path_of(name);
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable(("##" + name).c_str(), name == selected_, ImGuiSelectableFlags_AllowDoubleClick)) {
      select(name);
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        files_.open(keeping_.presets().path_of(name).string());
    }
    ui_map_.mark_item("preset=" + name);
    draw_fitted_text(*ImGui::GetWindowDrawList(), {place.x + scaled(4), place.y}, width - scaled(8),
                     is_scene && name != selected_ ? theme().accent : theme().text, name);
  }
  ImGui::EndChild();
}

void PresetsPanel::draw_question() {
  const bool removes = question_ == Question::remove;
  ImGui::AlignTextToFramePadding();
  fitted_text((removes ? "Delete " : "Replace ") + selected_ + "?",
              ImGui::GetContentRegionAvail().x - scaled(120), theme().text);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - scaled(112));
  const bool agreed = ImGui::Button(removes ? "Delete" : "Replace");
  ui_map_.mark_item("preset:yes");
  ImGui::SameLine();
  if (ImGui::Button("No") || agreed) question_ = Question::none;
  if (!agreed) return;
  removes ? remove() : save(std::string(selected_), true);
}

void PresetsPanel::draw_actions() {
  if (question_ != Question::none) return draw_question();
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  if (ImGui::Button("Load", {width, 0})) files_.open(keeping_.presets().path_of(selected_).string());
  ui_map_.mark_item("preset:load");
  ImGui::SameLine();
  if (ImGui::Button("Replace", {width, 0})) question_ = Question::replace;
  ui_map_.mark_item("preset:replace");
  help_for_item("Put the settings as they are now in this preset's place.");
  ImGui::SameLine();
  if (ImGui::Button("Delete", {width, 0})) question_ = Question::remove;
  ui_map_.mark_item("preset:delete");
}

void PresetsPanel::draw_comparison() {
  if (compared_revision_ != document_.revision()) {
    const std::array both{NamedSettings{"now", with_absolute_paths(document_.settings())},
                          NamedSettings{selected_, *settings_}};
    table_ = compare_settings(both);
    compared_revision_ = document_.revision();
  }
  if (table_.rows.empty()) return faint_text("Nothing differs from the settings now.");
  faint_text(std::to_string(table_.rows.size()) + (table_.rows.size() == 1 ? " difference" : " differences"));
  const float button = button_width("Copy");
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
  if (ImGui::Button("Copy")) ImGui::SetClipboardText(table_text(table_).c_str());
  ui_map_.mark_item("preset:copy table");
  constexpr ImGuiTableFlags kTableFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH;
  if (!ImGui::BeginTable("differences", 3, kTableFlags)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("parameter", ImGuiTableColumnFlags_WidthStretch, 1.5F);
  ImGui::TableSetupColumn("now", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("preset", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableNextRow();
  for (const char* title : {"Parameter", "Now", "Preset"}) {
    ImGui::TableNextColumn();
    faint_text(title);
  }
  for (const PresetTable::Row& row : table_.rows) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    fitted_text(row.key, ImGui::GetContentRegionAvail().x, theme().text);
    for (const std::optional<Value>& value : row.values) {
      ImGui::TableNextColumn();
      fitted_text(cell_text(value), ImGui::GetContentRegionAvail().x,
                  &value == &row.values.front() ? theme().text : theme().accent);
    }
  }
  ImGui::EndTable();
}

void PresetsPanel::draw() {
  if (--frames_to_listing_ < 0) list_again();
  draw_saving();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float wanted = line * static_cast<float>(std::max<size_t>(names_.size(), 3)) + scaled(4);
  draw_list(std::min(wanted, ImGui::GetContentRegionAvail().y * 0.5F));
  if (selected_.empty()) return;
  ImGui::Separator();
  draw_actions();
  if (settings_) return draw_comparison();
  wrapped_text(fault_, theme().error);
}

}  // namespace inkbench
