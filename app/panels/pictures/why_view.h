// SPDX-License-Identifier: MIT
// Why the marked pixel is or is not a line: a sentence, the sum against the threshold, and what each term is
// made of.
#pragma once

#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/workbench/document.h"

namespace inkbench {

/// With what would draw or remove it, a click each, and why it is false or missed where that is known.
/// Draws into the current ImGui window; nothing but a hint where no pixel is marked.
void draw_why(Document& document, Viewer& viewer, ViewState& view, UiMap& ui_map);

}  // namespace inkbench
