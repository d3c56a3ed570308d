// SPDX-License-Identifier: MIT
// A brush that is a picture. In: a file. Out: its paint.
#pragma once

#include <string>

#include "pipeline/base/key.h"
#include "pipeline/image/image.h"

namespace inkbench {

/// H x W x 1: 0 no paint to 1 all of it: the picture's alpha where it has some, else its darkness. Without a
/// file one pixel of paint. Errors (input): as `read_image`.
Image brush_paint(const std::string& path);

/// Of what is in the file. Errors (input): it cannot be read.
Key brush_image_key(const std::string& path);

/// Halved, each pixel the mean of two, as long as more than two would lie on one of the drawing: `across_px`
/// is how wide strokes are, `along_px` how long the picture is on them.
Image reduced_paint(Image paint, float along_px, float across_px);

}  // namespace inkbench
