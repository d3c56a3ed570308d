// "Sweep this" in a parameter's menu, and the key for it.
#pragma once

#include <string>

#include "app/window/workbench.h"

namespace inkbench {

/// Entries for an open menu: a study of its own, or another axis of the one that is being made. Nothing for
/// what cannot be swept.
void sweep_menu_items(Workbench& bench, const std::string& key);

/// For the last item, a parameter's: S while the mouse is on it is "sweep this", with Shift another axis.
void sweep_key(Workbench& bench, const std::string& key);

}  // namespace inkbench
