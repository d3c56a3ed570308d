// SPDX-License-Identifier: MIT
// "Sweep this" in a parameter's menu, and the key for it.
#pragma once

#include <string>

#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

/// Entries for an open menu: a study of its own, or another axis of the one that is being made. Nothing for
/// what cannot be swept.
void sweep_menu_items(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map,
                      const std::string& key);

/// For the last item, a parameter's: S while the mouse is on it is "sweep this", with Shift another axis.
void sweep_key(const Document& document, Studies& studies, Problems& problems, const std::string& key);

}  // namespace inkbench
