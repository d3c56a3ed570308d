// SPDX-License-Identifier: MIT
// Whether a tooltip is about to appear, so that the window draws a frame for it though nothing else happens.
#pragma once

namespace inkbench {

/// The mouse rests on an item with help, but not yet long enough. After the panels were drawn.
bool is_hover_pending();

}  // namespace inkbench
