// SPDX-License-Identifier: MIT
#include "app/panels/frame/timings.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

void right_text(const std::string& text, ImU32 colour) {
  const float spare = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (spare > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + spare);
  coloured_text(colour, text);
}

std::string ms_text(double ms) {
  if (!(ms > 0.0)) return "";
  return fmt::format("{:.{}f}", ms, ms < 100.0 ? 2 : (ms < 1000.0 ? 1 : 0));
}

/// A bar as long as its share of the longest pass.
void time_bar(double share, bool ran) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetTextLineHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float inset = scaled(4);
  list.AddRectFilled({low.x, low.y + inset},
                     {low.x + std::max(static_cast<float>(share) * width, 1.0F), low.y + height - inset},
                     ran ? theme().accent : theme().field_hot, scaled(2));
  ImGui::Dummy({width, height});
}

void pass_row(const std::string& name, const PassTime& time, const StageCount* count, double longest) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  coloured_text(time.ran ? theme().text : theme().faint, name);
  ImGui::TableNextColumn();
  const bool ever = time.ran || time.last_ms > 0.0;
  std::string what = time.ran ? "ran" : (ever ? "reused" : "not needed");
  if (time.ran && time.runs_in_change > 1) what += fmt::format(" {}x", time.runs_in_change);
  coloured_text(time.ran ? theme().accent : theme().faint, what);
  ImGui::TableNextColumn();
  right_text(ms_text(time.last_ms), time.ran ? theme().text : theme().faint);
  ImGui::TableNextColumn();
  right_text(ms_text(time.mean_ms), theme().faint);
  ImGui::TableNextColumn();
  time_bar(longest > 0.0 ? time.last_ms / longest : 0.0, time.ran);
  ImGui::TableNextColumn();
  if (count != nullptr) right_text(with_commas(count->runs), theme().faint);
  ImGui::TableNextColumn();
  if (count != nullptr) right_text(with_commas(count->reuses), theme().faint);
}

/// Columns that a narrow panel leaves out.
bool is_spare(int column) {
  return column == 3 || column == 4 || column == 6;
}

/// `names_width` is that of the widest pass's name.
void head(bool narrow, float names_width) {
  const std::array<std::pair<const char*, float>, 7> columns{{{"pass", narrow ? scaled(84) : names_width},
                                                              {"last change", scaled(84)},
                                                              {"ms", scaled(42)},
                                                              {"mean", scaled(42)},
                                                              {"##bar", 0},
                                                              {"runs", scaled(40)},
                                                              {"reuses", scaled(52)}}};
  for (size_t i = 0; i < columns.size(); ++i) {
    const auto& [name, width] = columns[i];
    const bool stretches = width == 0.0F;
    ImGui::TableSetupColumn(
        name, stretches ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed, width);
    const int column = static_cast<int>(i);
    ImGui::TableSetColumnEnabled(column, !narrow || !is_spare(column));
  }
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableNextRow();
  for (int i = 0; i < 7; ++i) {
    ImGui::TableNextColumn();
    const std::string name = ImGui::TableGetColumnName(i);
    if (name.starts_with("##")) continue;
    if (i < 2) {
      faint_text(name);
    } else {
      right_text(name, theme().faint);
    }
  }
}

}  // namespace

void draw_timings(const Pipeline& pipeline, const PassTimer& passes, const PassTimer& window) {
  const std::map<std::string, StageCount> counts = pipeline.counts();
  std::vector<std::pair<std::string, PassTime>> rows;
  for (const std::string& name : pipeline.pass_names()) rows.emplace_back(name, passes.time_of(name));
  for (const char* name : {"tiles", "window"}) rows.emplace_back(name, window.time_of(name));
  double longest = 0.0;
  float names_width = 0.0F;
  for (const auto& [name, time] : rows) {
    longest = std::max(longest, time.last_ms);
    names_width = std::max(names_width, ImGui::CalcTextSize(name.c_str()).x);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(scaled(5), scaled(1)));
  const bool narrow = ImGui::GetContentRegionAvail().x < scaled(430);
  const bool open = ImGui::BeginTable("timings", 7, ImGuiTableFlags_ScrollY | ImGuiTableFlags_Hideable);
  ImGui::PopStyleVar();
  if (!open) return;
  head(narrow, names_width);
  for (const auto& [name, time] : rows) {
    const auto count = counts.find(name);
    pass_row(name, time, count == counts.end() ? nullptr : &count->second, longest);
  }
  ImGui::EndTable();
}

}  // namespace inkbench
