// What keys do, wherever the mouse is.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// What a key asks of panels.
struct ShortcutRequests {
  bool search = false, open = false;
};

/// Once a frame; keys that a text field wants are its own.
ShortcutRequests handle_shortcuts(Workbench& bench);

}  // namespace inkbench
