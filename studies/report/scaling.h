// Pictures at another size. In: a picture and a size. Out: the picture at that size. Used by the image grid
// and the report page's thumbnails.
#pragma once

#include "pipeline/image/image.h"

namespace inkbench {

/// What is averaged: `light` keeps the weight of things seen from afar; `codes` (the samples as they are)
/// keeps thin dark lines on a light ground darker than that.
enum class Averaging { light, codes };

/// The mean over the area that each new pixel covers, taken by default in linear light (sRGB decoded and
/// encoded again), so that thin ink keeps the weight it has when seen from afar; no ringing beside lines as
/// sharper filters have. At the picture's own size, the picture itself.
Picture scaled(const Picture& picture, int width_px, int height_px, Averaging averaging = Averaging::light);

}  // namespace inkbench
