// SPDX-License-Identifier: MIT
// Letter keys by what is printed on them, and whose the keys are.
#pragma once

#include "app/workbench/window_layout.h"

namespace inkbench {

/// The key went down in this frame, by the letter on it, whatever the keyboard's layout.
bool letter_pressed(char letter);

/// Whether a menu, a dialog or another popup is open, which has the keys then.
bool popup_is_open();

/// Whether keys without Ctrl and Alt mean what is shown: no text field, no popup and no page over the panels
/// has them.
bool keys_are_free(const WindowLayout& layout);

}  // namespace inkbench
