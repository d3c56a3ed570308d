// SPDX-License-Identifier: MIT
// One picture in the window: drawn at its tile's size, with the mouse's zoom, pan, camera and brush on it.
#pragma once

#include <imgui.h>

#include <string>

#include "app/window/pictures.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/workbench/document.h"

namespace inkbench {

struct TileRect {
  ImVec2 low, high;
  float width() const { return high.x - low.x; }
  float height() const { return high.y - low.y; }
};

/// Draws a picture's part that the view shows into the rectangle; nothing where there is no picture yet.
/// `clip`: what of the rectangle is drawn.
void draw_picture(const Document& document, Viewer& viewer, ViewState& view, const std::string& slot,
                  const ComparedPicture& which, const TileRect& rect, const TileRect& clip);

/// What the mouse did on a tile besides zoom, pan, camera and brush, which are done here.
struct TileMouse {
  bool hovered = false, clicked = false, double_clicked = false;
};

/// An ImGui item over the rectangle that takes the mouse.
TileMouse handle_tile_mouse(Document& document, Viewer& viewer, ViewState& view, UiMap& ui_map,
                            const std::string& id, const ComparedPicture& which, const TileRect& rect);

/// The rectangle and the picture in it, for `view_state.h`.
TileFrame frame_of(const Pictures& pictures, const ComparedPicture& which, const TileRect& rect);

}  // namespace inkbench
