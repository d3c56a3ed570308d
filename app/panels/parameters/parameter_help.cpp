// SPDX-License-Identifier: MIT
#include "app/panels/parameters/parameter_help.h"

#include <imgui.h>

#include <cmath>

#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

bool is_number(const Field& field) {
  return field.type == FieldType::integer || field.type == FieldType::real || field.type == FieldType::vector;
}

std::string limit_text(const Field& field, double limit) {
  return field.type == FieldType::integer ? with_commas(std::llround(limit)) : shortest(limit);
}

std::string limits_text(const Field& field) {
  std::string text = limit_text(field, field.limits.low) + " to " + limit_text(field, field.limits.high);
  if (!field.unit.empty()) text += " " + std::string(field.unit);
  return text;
}

std::string shown_text(const Field& field, const Value& value) {
  const std::string text = to_text(value);
  return text == "0" && !field.zero_text.empty() ? std::string(field.zero_text) : text;
}

std::string how_text(const Field& field) {
  if (is_number(field)) return "Drag, Shift for finer steps. Ctrl+click types. Right click resets.";
  return "Right click resets.";
}

void line(std::string_view name, const std::string& text) {
  faint_text(name);
  ImGui::SameLine(scaled(76));
  ImGui::TextUnformatted(text.c_str());
}

}  // namespace

void help_for_parameter(const RowContext& row) {
  if (hover_seconds() < kHelpDelay) return;
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0F);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(360));
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(row.key.c_str());
  ImGui::PopFont();
  ImGui::TextUnformatted(row.field->help.data(), row.field->help.data() + row.field->help.size());
  ImGui::Dummy({0, scaled(1)});
  if (is_number(*row.field)) line("Limits", limits_text(*row.field));
  if (row.value != row.baseline) line("Was", shown_text(*row.field, row.baseline));
  if (!row.field->matters_when.empty()) {
    const std::string text = "Matters when " + std::string(row.field->matters_when);
    coloured_text(row.matters ? theme().faint : theme().warning, text);
  }
  faint_text(how_text(*row.field));
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace inkbench
