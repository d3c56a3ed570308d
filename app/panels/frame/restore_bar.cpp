// SPDX-License-Identifier: MIT
#include "app/panels/frame/restore_bar.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

#include <chrono>

#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "app/workbench/param_changes.h"

namespace inkbench {
namespace {

std::string time_text(std::filesystem::file_time_type time) {
  const auto since = std::filesystem::file_time_type::clock::to_sys(time);
  const std::time_t seconds = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(since));
  return fmt::format("{:%d %b, %H:%M}", fmt::localtime(seconds));
}

std::string work_text(const Document& document, const UnsavedWork& work) {
  const auto changes = changed_params(document.settings(), work.session.settings);
  const std::string scene = work.session.scene.empty() ? "unnamed" : work.session.scene.filename().string();
  return fmt::format("Of {}, {}: {}", time_text(work.time), scene, changes_name(changes));
}

}  // namespace

float restore_bar_height(const Keeping& keeping) {
  if (keeping.unsaved().empty()) return 0;
  return 2 * ImGui::GetTextLineHeight() + scaled(20);
}

void draw_restore_bar(Document& document, WindowLayout& layout, Keeping& keeping, UiMap& ui_map) {
  if (keeping.unsaved().empty()) return;
  const float pad = scaled(10);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float buttons = scaled(168);
  const float height = restore_bar_height(keeping) - scaled(4);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + height}, theme().bar, scaled(3));
  list.AddRectFilled(low, {low.x + scaled(4), low.y + height}, theme().accent, scaled(2));
  ImVec2 place{low.x + pad + scaled(4), low.y + scaled(6)};
  list.AddText(fonts().bold, ImGui::GetFontSize(), place, theme().text,
               "There is unsaved work from a window that was not closed.");
  place.y += ImGui::GetTextLineHeight() + scaled(3);
  draw_fitted_text(list, place, width - buttons - 2 * pad, theme().faint,
                   work_text(document, keeping.unsaved().front()));
  ImGui::SetCursorScreenPos({low.x + width - buttons, low.y + (height - ImGui::GetFrameHeight()) / 2});
  const bool restores = ImGui::Button("Restore");
  ui_map.mark_item("restore");
  ImGui::SameLine();
  const bool discards = ImGui::Button("Discard");
  ui_map.mark_item("discard");
  ImGui::SetCursorScreenPos({low.x, low.y + height + scaled(4)});
  if (restores) keeping.restore(document, layout);
  if (discards) keeping.discard();
}

}  // namespace inkbench
