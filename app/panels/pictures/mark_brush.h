// SPDX-License-Identifier: MIT
// Painting what is wanted and what is not over the pictures: the brush, what it has painted, and its tools.
#pragma once

#include "app/panels/pictures/picture_tile.h"

namespace inkbench {

/// For the last ImGui item, a picture's tile, while the brush is the tool: left drag paints, one stroke one
/// step of undo; Ctrl and the wheel change the brush's size. Returns whether the mouse is the brush's now.
bool brush_mouse(Document& document, Viewer& viewer, ViewState& view, const TileFrame& frame);

/// The marks of the present camera and the stroke that is being painted, over a picture that was drawn into
/// the frame, inside the current clip rectangle.
void draw_marks(const Document& document, Viewer& viewer, const ViewState& view, const TileFrame& frame);

/// A row of tools, while the brush is the tool.
void draw_brush_tools(Document& document, ViewState& view, UiMap& ui_map);

}  // namespace inkbench
