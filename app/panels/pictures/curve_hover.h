// SPDX-License-Identifier: MIT
// The curve under the mouse: lit over the picture, with what it is beside it.
#pragma once

#include "app/window/view_state.h"
#include "app/window/viewer.h"

namespace inkbench {

/// For the picture that the mouse is on, into the current ImGui window: the nearest curve within a few window
/// pixels, in pictures in which curves are seen. Nothing while a button is down.
void draw_curve_under_mouse(Viewer& viewer, ViewState& view, const ComparedPicture& which,
                            const TileFrame& frame);

}  // namespace inkbench
