// SPDX-License-Identifier: MIT
#include "app/panels/frame/shaders_menu.h"

#include <imgui.h>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "app/workbench/open_outside.h"
#include "pipeline/base/files.h"

namespace inkbench {

void shaders_menu(Problems& problems, UiMap& ui_map) {
  const bool open = ImGui::BeginMenu("Shaders");
  ui_map.mark_item("menu:Shaders");
  if (!open) return;
  const fs::path folder = project_root() / "shaders";
  faint_text(folder.string());
  faint_text("A shader that is saved is in use at once; errors are in the log.");
  ImGui::Separator();
  if (ImGui::MenuItem("Open the folder")) attempt(problems, [&] { open_outside(folder); });
  ui_map.mark_item("menu:Open the folder");
  if (ImGui::MenuItem("Copy its path")) {
    ImGui::SetClipboardText(folder.c_str());
    problems.tell(Severity::note, "copied " + folder.string());
  }
  ui_map.mark_item("menu:Copy its path");
  ImGui::EndMenu();
}

}  // namespace inkbench
