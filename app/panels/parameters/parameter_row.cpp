// SPDX-License-Identifier: MIT
#include "app/panels/parameters/parameter_row.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>

#include "app/panels/parameters/light_ball.h"
#include "app/panels/parameters/parameter_help.h"
#include "app/panels/parameters/sweep_menu.h"
#include "app/panels/widgets/colour_picker.h"
#include "app/panels/widgets/value_bar.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "app/workbench/render_command_text.h"
#include "pipeline/base/text.h"
#include "pipeline/settings/ramp.h"

namespace inkbench {
namespace {

void apply_bar(Document& document, const std::string& key, const BarResult& bar, bool whole) {
  if (bar.pressed) document.begin_edit();
  if (bar.dragged) {
    document.change(key, whole ? Value(static_cast<int>(bar.value)) : Value(static_cast<float>(bar.value)));
  }
  if (bar.released) document.end_edit();
  if (!bar.typed.empty()) document.change_text(key, bar.typed);
}

void number_editor(Document& document, Studies& studies, const FitDesk& fit, Problems& problems,
                   UiMap& ui_map, const RowContext& row, float width) {
  const bool whole = row.field->type == FieldType::integer;
  const double value = whole ? std::get<int>(row.value) : std::get<float>(row.value);
  const BarResult bar = value_bar("value", value, *row.field, width, fit.heat(row.key));
  ui_map.mark_item("bar:" + row.key);
  sweep_key(document, studies, problems, row.key);
  help_for_parameter(row);
  apply_bar(document, row.key, bar, whole);
  if (bar.reset) document.reset(row.key);
}

void vector_editor(Document& document, Studies& studies, Problems& problems, UiMap& ui_map,
                   const RowContext& row, float width) {
  const auto value = std::get<glm::vec3>(row.value);
  const float gap = scaled(3);
  const float each = (width - 2 * gap) / 3;
  constexpr std::array kNames{"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const std::string key = row.key + "." + kNames[i];
    if (i > 0) ImGui::SameLine(0, gap);
    const BarResult bar = value_bar(kNames[i], value[i], *row.field, each);
    ui_map.mark_item("bar:" + key);
    sweep_key(document, studies, problems, key);
    help_for_parameter(row);
    apply_bar(document, key, bar, false);
    if (bar.reset) document.reset(key);
  }
  if (is_light_direction(row)) light_ball(document, ui_map, row);
}

void colour_editor(Document& document, UiMap& ui_map, const RowContext& row, float width) {
  const auto& colour = std::get<glm::vec3>(row.value);
  const bool opens = colour_swatch(colour, width);
  ui_map.mark_item("colour:" + row.key);
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) document.reset(row.key);
  help_for_parameter(row);
  colour_picker(document, ui_map, "picker:" + row.key, colour, opens,
                [&](const glm::vec3& next) { document.change(row.key, next); });
}

void choice_editor(Document& document, UiMap& ui_map, const RowContext& row, float width) {
  const auto& current = std::get<std::string>(row.value);
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##choice", current.c_str(), ImGuiComboFlags_HeightLarge);
  ui_map.mark_item("choice:" + row.key);
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) document.reset(row.key);
  if (!open) {
    help_for_parameter(row);
    return;
  }
  for (const std::string_view choice : row.field->choices) {
    const std::string name(choice);
    if (ImGui::Selectable(name.c_str(), name == current)) document.change(row.key, name);
    ui_map.mark_item("choice:" + row.key + "=" + name);
  }
  ImGui::EndCombo();
}

void boolean_editor(Document& document, UiMap& ui_map, const RowContext& row) {
  bool on = std::get<bool>(row.value);
  if (ImGui::Checkbox("##on", &on)) document.change(row.key, on);
  ui_map.mark_item("check:" + row.key);
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) document.reset(row.key);
  help_for_parameter(row);
}

void text_editor(Document& document, UiMap& ui_map, const RowContext& row, float width) {
  std::string text = std::get<std::string>(row.value);
  ImGui::SetNextItemWidth(width);
  ImGui::InputText("##text", &text, ImGuiInputTextFlags_AutoSelectAll);
  ui_map.mark_item("text:" + row.key);
  if (ImGui::IsItemDeactivatedAfterEdit()) document.change_text(row.key, to_text(Value(text)));
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) document.reset(row.key);
  if (!ImGui::IsItemActive()) help_for_parameter(row);
}

/// As text, with a button that opens what draws it by hand.
void profile_editor(Document& document, ViewState& view, UiMap& ui_map, const RowContext& row, float width) {
  const float button = button_width("Draw");
  text_editor(document, ui_map, row, width - button - scaled(4));
  ImGui::SameLine(0, scaled(4));
  if (ImGui::Button("Draw")) view.editor = OpenEditor::style;
  ui_map.mark_item("draw:" + row.key);
}

/// The ramp's colours from 0 to 1; an image's are not read here.
void ramp_strip(ViewState& view, UiMap& ui_map, const RowContext& row, float width) {
  const auto& ramp = std::get<Ramp>(row.value);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  if (ImGui::InvisibleButton("ramp", {width, height})) view.editor = OpenEditor::ramps;
  ui_map.mark_item("strip:" + row.key);
  const bool hot = ImGui::IsItemHovered();
  if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!ramp.image.empty()) {
    list.AddRectFilled(low, {low.x + width, low.y + height}, ImGui::GetColorU32(theme().field));
    draw_fitted_text(list, {low.x + scaled(6), low.y + scaled(3)}, width - scaled(12),
                     ImGui::GetColorU32(theme().text), ramp.image);
  } else {
    for (float x = 0; x < width; ++x) {
      const glm::vec3 c = evaluate_ramp(ramp, (x + 0.5F) / width);
      list.AddRectFilled({low.x + x, low.y}, {low.x + x + 1, low.y + height},
                         ImGui::GetColorU32(ImVec4(c.x, c.y, c.z, 1)));
    }
  }
  list.AddRect(low, {low.x + width, low.y + height}, hot ? theme().accent : theme().line);
  help_for_parameter(row);
}

void editor(Document& document, ViewState& view, Studies& studies, const FitDesk& fit, Problems& problems,
            UiMap& ui_map, const RowContext& row, float width) {
  switch (row.field->type) {
    case FieldType::boolean:
      return boolean_editor(document, ui_map, row);
    case FieldType::integer:
    case FieldType::real:
      return number_editor(document, studies, fit, problems, ui_map, row, width);
    case FieldType::vector:
      return vector_editor(document, studies, problems, ui_map, row, width);
    case FieldType::colour:
      return colour_editor(document, ui_map, row, width);
    case FieldType::choice:
      return choice_editor(document, ui_map, row, width);
    case FieldType::text:
      if (row.field->is_profile) return profile_editor(document, view, ui_map, row, width);
      return text_editor(document, ui_map, row, width);
    case FieldType::ramp:
      return ramp_strip(view, ui_map, row, width);
  }
}

void changed_mark(Document& document, UiMap& ui_map, const RowContext& row) {
  const float size = scaled(14);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  const bool changed = row.value != row.baseline;
  if (ImGui::InvisibleButton("changed", {size, height}) && changed) document.reset(row.key);
  if (!changed) return;
  ui_map.mark_item("changed:" + row.key);
  const float radius = ImGui::IsItemHovered() ? scaled(4) : scaled(3);
  ImGui::GetWindowDrawList()->AddCircleFilled({low.x + size / 2 - scaled(1), low.y + height / 2}, radius,
                                              theme().accent);
  help_for_item("Changed. Click to put back " + to_text(row.baseline));
}

void fit_menu_item(const Document& document, FitDesk& fit, UiMap& ui_map, const std::string& key) {
  if (!can_fit(document.settings(), key)) return;
  const bool on = fit.is_ticked(document.settings(), key);
  if (ImGui::MenuItem("Let a fit move it", nullptr, on)) fit.tick(key, !on);
  ui_map.mark_item("let fit:" + key);
}

void name_menu(Document& document, Studies& studies, FitDesk& fit, Problems& problems, UiMap& ui_map,
               const RowContext& row) {
  if (!ImGui::BeginPopupContextItem("name menu")) return;
  faint_text(row.key);
  ImGui::Separator();
  const std::string back = "Reset to " + to_text(row.baseline).substr(0, 40);
  if (ImGui::MenuItem(back.c_str(), nullptr, false, row.value != row.baseline)) document.reset(row.key);
  if (ImGui::MenuItem("Copy name")) ImGui::SetClipboardText(row.key.c_str());
  if (ImGui::MenuItem("Copy as --set"))
    ImGui::SetClipboardText(("--set " + shell_word(assignment_text(*row.field, row.key, row.value))).c_str());
  sweep_menu_items(document, studies, problems, ui_map, row.key);
  fit_menu_item(document, fit, ui_map, row.key);
  ImGui::EndPopup();
}

}  // namespace

void parameter_row(Document& document, ViewState& view, Studies& studies, FitDesk& fit, Problems& problems,
                   UiMap& ui_map, const RowContext& row) {
  ImGui::PushID(row.key.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, row.matters ? 1.0F : 0.4F);
  changed_mark(document, ui_map, row);
  ImGui::SameLine(0, 0);
  const ImVec2 place = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("name", {row.name_width, ImGui::GetFrameHeight()});
  ui_map.mark_item("name:" + row.key);
  help_for_parameter(row);
  draw_fitted_text(*ImGui::GetWindowDrawList(), {place.x, place.y + ImGui::GetStyle().FramePadding.y},
                   row.name_width - scaled(4), ImGui::GetColorU32(theme().text), row.field->name);
  sweep_key(document, studies, problems, row.key);
  name_menu(document, studies, fit, problems, ui_map, row);
  ImGui::SameLine(0, 0);
  editor(document, view, studies, fit, problems, ui_map, row,
         std::max(ImGui::GetContentRegionAvail().x, scaled(40)));
  ImGui::PopStyleVar();
  ImGui::PopID();
}

}  // namespace inkbench
