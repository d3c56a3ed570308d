// Moving the camera with the mouse on a picture.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// For the last ImGui item, a picture's tile. With Alt, or with the camera tool: left drag orbits about the
/// target, middle drag or Shift and left drag pans, right drag or the wheel moves nearer or farther. Returns
/// whether the mouse is the camera's now, so that it does not move the view.
bool camera_mouse(Workbench& bench, const TileFrame& frame);

}  // namespace inkbench
