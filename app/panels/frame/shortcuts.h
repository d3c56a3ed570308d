// What keys do, wherever the mouse is.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// What a key asks of panels.
struct ShortcutRequests {
  bool search = false;
};

/// Once a frame; keys that a text field wants are its own.
ShortcutRequests handle_shortcuts(Workbench& bench);

/// Larger or smaller by so many times the usual size.
void change_text_size(Workbench& bench, float change);

}  // namespace inkbench
