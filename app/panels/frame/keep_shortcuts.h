// The keys of what is kept: undo, files, views.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// Once a frame, before the other keys. Returns whether a key was one of these.
bool handle_keep_shortcuts(Workbench& bench);

}  // namespace inkbench
