// Why the marked pixel is or is not a line: a sentence, the sum against the threshold, and what each term is
// made of.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// Draws into the current ImGui window; nothing but a hint where no pixel is marked.
void draw_why(Workbench& bench);

}  // namespace inkbench
