// SPDX-License-Identifier: MIT
#include "app/panels/frame/edit_menu.h"

#include <imgui.h>

#include "app/panels/widgets/clipboard.h"
#include "app/panels/widgets/widgets.h"

namespace inkbench {
namespace {

constexpr size_t kLongestStep = 40;

bool item(UiMap& ui_map, const std::string& label, const char* keys = nullptr, bool can = true,
          const char* mark = nullptr) {
  const bool chosen = ImGui::MenuItem(label.c_str(), keys, false, can);
  ui_map.mark_item("menu:" + (mark != nullptr ? std::string(mark) : label));
  return chosen;
}

std::string with_step(const char* verb, const std::string& step) {
  if (step.empty()) return verb;
  if (step.size() <= kLongestStep) return std::string(verb) + " " + step;
  size_t end = kLongestStep;
  while (end > 0 && (static_cast<unsigned char>(step[end]) & 0xc0) == 0x80) --end;  // not within a letter
  return std::string(verb) + " " + step.substr(0, end) + "…";
}

}  // namespace

void draw_edit_menu(Document& document, const Pictures& pictures, const ViewState& view, FileOpener& files,
                    Problems& problems, UiMap& ui_map) {
  const bool open = ImGui::BeginMenu("Edit");
  ui_map.mark_item("menu:Edit");
  if (!open) return;
  const History& history = document.history();
  if (item(ui_map, with_step("Undo", history.undo_name()), "Ctrl+Z", history.can_undo(), "Undo"))
    document.undo();
  if (item(ui_map, with_step("Redo", history.redo_name()), "Ctrl+Shift+Z", history.can_redo(), "Redo"))
    document.redo();
  ImGui::Separator();
  if (item(ui_map, "Copy as a command", "Ctrl+Shift+C"))
    copy_render_command(document, pictures, view, problems);
  if (item(ui_map, "Copy settings")) copy_settings(document, problems);
  if (item(ui_map, "Paste settings or a path", "Ctrl+V")) paste(document, files, problems);
  ImGui::Separator();
  if (item(ui_map, "Reset all to the scene")) document.replace(document.baseline(), "reset all");
  ImGui::EndMenu();
}

}  // namespace inkbench
