// SPDX-License-Identifier: MIT
// The pixel that is asked about: marking it with the mouse, moving it with the keys, showing it on a picture.
#pragma once

#include "app/window/pictures.h"
#include "app/window/view_state.h"
#include "app/workbench/document.h"

namespace inkbench {

/// After the tile's item: a click that drags nothing marks the pixel under the mouse. The second click of two
/// fills the window instead and leaves the mark as it was. `pinned`: the picture is one of the pinned state.
void mark_with_mouse(ViewState& view, const TileFrame& frame, bool pinned);

/// Moves the mark by so many pixels, as far as the image that it asks of goes.
void move_mark(const Document& document, const Pictures& pictures, ViewState& view, int dx, int dy);

/// On a picture that was drawn into the frame, inside the current clip rectangle.
void draw_mark(const ViewState& view, const TileFrame& frame);

}  // namespace inkbench
