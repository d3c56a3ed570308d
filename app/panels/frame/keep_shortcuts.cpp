// SPDX-License-Identifier: MIT
#include "app/panels/frame/keep_shortcuts.h"

#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include "app/panels/frame/file_dialogs.h"
#include "app/panels/frame/shortcuts.h"
#include "app/panels/pictures/views_panel.h"
#include "app/panels/widgets/clipboard.h"
#include "app/panels/widgets/held_drag.h"
#include "app/panels/widgets/letter_key.h"

namespace inkbench {

bool KeepShortcuts::ask(FileDialog dialog) {
  wanted_dialog_ = dialog;
  return true;
}

bool KeepShortcuts::file_keys(bool shift) {
  if (letter_pressed('o')) return ask(FileDialog::open);
  if (letter_pressed('e')) return ask(FileDialog::save_image);
  if (!letter_pressed('s')) return false;
  if (shift) return ask(FileDialog::save_settings);
  save_settings(document_, problems_, wanted_dialog_);
  return true;
}

/// Keys that mean something else while a text is typed.
bool KeepShortcuts::editing_keys(bool shift) {
  if (letter_pressed('z')) {
    shift ? document_.redo() : document_.undo();
  } else if (letter_pressed('y')) {
    document_.redo();
  } else if (shift && letter_pressed('c')) {
    copy_render_command(document_, pictures_, view_, problems_);
  } else if (letter_pressed('v')) {
    paste(document_, files_, problems_);
  } else {
    return false;
  }
  return true;
}

bool KeepShortcuts::view_keys(bool control, bool shift) {
  if (!control && letter_pressed('w')) {
    view_.wireframe = !view_.wireframe;
    return true;
  }
  if (!control && letter_pressed('x')) {
    toggle_projection(document_, pictures_, problems_);
    return true;
  }
  for (int key = 1; key <= 9; ++key) {
    if (!ImGui::IsKeyPressed(GLFW_KEY_0 + key, false) || control == shift) continue;
    control ? keep_view(document_, keeping_, problems_, key)
            : recall_view(document_, keeping_, problems_, key);
    return true;
  }
  if (control || !ImGui::IsKeyPressed(GLFW_KEY_HOME, false)) return false;
  fit_view(document_, pictures_, problems_, shift ? FitTo::model : FitTo::scene);
  return true;
}

/// Esc while something is dragged or typed that changes the document takes it back, and does nothing else.
bool KeepShortcuts::cancels_edit(bool popup) {
  const bool in_popup = popup && document_.is_editing() && ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false);
  if (!give_up_drag() && !in_popup) return false;
  document_.cancel_edit();
  return true;
}

bool KeepShortcuts::handle(bool pictures_shown, bool is_covered) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool popup = popup_is_open();
  if (cancels_edit(popup)) return true;
  if (popup && ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false) && ImGui::GetTopMostPopupModal() == nullptr) {
    ImGui::ClosePopupToLevel(0, true);  // menus; dialogs close themselves
    return true;
  }
  if (popup || io.KeyAlt) return false;
  if (io.KeyCtrl && file_keys(io.KeyShift)) return true;
  if (io.WantTextInput || is_covered) return false;
  if (io.KeyCtrl && editing_keys(io.KeyShift)) return true;
  return pictures_shown && view_keys(io.KeyCtrl, io.KeyShift);
}

}  // namespace inkbench
