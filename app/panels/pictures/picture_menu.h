// SPDX-License-Identifier: MIT
// What a right click on a picture offers.
#pragma once

#include "app/window/pictures.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

/// For the last ImGui item, the buffer's tile. Nothing while the mouse moves the camera.
void draw_picture_menu(const Document& document, Pictures& pictures, ViewState& view, Problems& problems,
                       WantedDialog& wanted_dialog, UiMap& ui_map, BufferName buffer);

}  // namespace inkbench
