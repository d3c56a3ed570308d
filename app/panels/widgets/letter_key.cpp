// SPDX-License-Identifier: MIT
#include "app/panels/widgets/letter_key.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace inkbench {

bool letter_pressed(char letter) {
  for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) {
    if (!ImGui::IsKeyPressed(key, false)) continue;
    const char* name = glfwGetKeyName(key, 0);
    const char shown = name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0'
                           ? name[0]
                           : static_cast<char>('a' + key - GLFW_KEY_A);
    if (shown == letter) return true;
  }
  return false;
}

bool popup_is_open() {
  return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool keys_are_free(const WindowLayout& layout) {
  const ImGuiIO& io = ImGui::GetIO();
  return !io.WantTextInput && !io.KeyCtrl && !io.KeyAlt && !popup_is_open() && !layout.show_welcome;
}

}  // namespace inkbench
