// SPDX-License-Identifier: MIT
// Where strokes are, so that what colours them leaves the rest of the image alone.
#pragma once

#include "pipeline/flow/image_window.h"
#include "pipeline/image/image.h"
#include "pipeline/strokes/stroke.h"

namespace inkbench {

/// A sample for each 8 x 8 pixels of the window, counted from its lower left corner as placing/tiles.h does:
/// 1 where a stroke may paint, else 0. A pixel that a stroke paints lies in a tile of 1.
Image stroke_tiles(const Strokes& strokes, const ImageWindow& window);

}  // namespace inkbench
