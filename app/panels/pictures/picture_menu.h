// What a right click on a picture offers.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// For the last ImGui item, the buffer's tile. Nothing while the mouse moves the camera.
void draw_picture_menu(Workbench& bench, BufferName buffer);

}  // namespace inkbench
