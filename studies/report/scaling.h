// Pictures at another size. In: a picture and a size. Out: the picture at that size. Used by the image grid.
#pragma once

#include "pipeline/image/image.h"

namespace inkbench {

/// The mean over the area that each new pixel covers, taken in linear light (sRGB decoded and encoded again),
/// so that thin ink keeps the weight it has when seen from afar; no ringing beside lines as sharper filters
/// have. At the picture's own size, the picture itself.
Picture scaled(const Picture& picture, int width_px, int height_px);

}  // namespace inkbench
