#include "app/panels/frame/keep_shortcuts.h"

#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include "app/panels/frame/file_dialogs.h"
#include "app/panels/frame/shortcuts.h"
#include "app/panels/pictures/views_panel.h"
#include "app/panels/widgets/clipboard.h"
#include "app/panels/widgets/letter_key.h"

namespace inkbench {
namespace {

bool ask(Workbench& bench, FileDialog dialog) {
  bench.wanted_dialog = dialog;
  return true;
}

bool file_keys(Workbench& bench, bool shift) {
  if (letter_pressed('o')) return ask(bench, FileDialog::open);
  if (letter_pressed('e')) return ask(bench, FileDialog::save_image);
  if (!letter_pressed('s')) return false;
  if (shift) return ask(bench, FileDialog::save_settings);
  save_settings(bench);
  return true;
}

/// Keys that mean something else while a text is typed.
bool editing_keys(Workbench& bench, bool shift) {
  if (letter_pressed('z')) {
    shift ? bench.redo() : bench.undo();
  } else if (letter_pressed('y')) {
    bench.redo();
  } else if (shift && letter_pressed('c')) {
    copy_render_command(bench);
  } else if (letter_pressed('v')) {
    paste(bench);
  } else {
    return false;
  }
  return true;
}

bool view_keys(Workbench& bench, bool control, bool shift) {
  if (!control && letter_pressed('w')) {
    bench.view.wireframe = !bench.view.wireframe;
    return true;
  }
  for (int key = 1; key <= 9; ++key) {
    if (!ImGui::IsKeyPressed(GLFW_KEY_0 + key, false) || control == shift) continue;
    control ? keep_view(bench, key) : recall_view(bench, key);
    return true;
  }
  if (control || !ImGui::IsKeyPressed(GLFW_KEY_HOME, false)) return false;
  fit_view(bench, shift ? FitTo::model : FitTo::scene);
  return true;
}

}  // namespace

bool handle_keep_shortcuts(Workbench& bench) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (popup && ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false) && ImGui::GetTopMostPopupModal() == nullptr) {
    ImGui::ClosePopupToLevel(0, true);  // menus; dialogs close themselves
    return true;
  }
  if (popup || io.KeyAlt) return false;
  if (io.KeyCtrl && file_keys(bench, io.KeyShift)) return true;
  if (io.WantTextInput) return false;
  return (io.KeyCtrl && editing_keys(bench, io.KeyShift)) || view_keys(bench, io.KeyCtrl, io.KeyShift);
}

}  // namespace inkbench
