// SPDX-License-Identifier: MIT
// Moving the camera with the mouse on a picture.
#pragma once

#include "app/window/view_state.h"
#include "app/workbench/document.h"

namespace inkbench {

/// For the last ImGui item, a picture's tile. With Alt, or with the camera tool: left drag orbits about the
/// target, middle drag or Shift and left drag pans, right drag or the wheel moves nearer or farther, in
/// orthographic views it shows less or more. Returns
/// whether the mouse is the camera's now, so that it does not move the view.
bool camera_mouse(Document& document, ViewState& view, const TileFrame& frame);

}  // namespace inkbench
