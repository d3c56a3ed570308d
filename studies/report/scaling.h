// SPDX-License-Identifier: MIT
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

/// Columns or rows, from `first` up to `end`.
struct Samples {
  int first = 0, end = 0;
  bool operator==(const Samples&) const = default;
};

/// The old columns (rows) that new one `index` is a mean of.
Samples covered_samples(int old_size, int new_size, int index);

/// From `old_width_px` to `width_px` x `height_px`; the old height is the picture's.
struct Scaling {
  int old_width_px = 0;
  int width_px = 0, height_px = 0;
};

/// The `wanted` columns of what `scaled` makes of a picture of which `part` holds the columns from `origin`
/// on, at least those that the wanted ones cover. Sample for sample what `scaled` gives.
Picture scaled_columns(const Picture& part, int origin, const Scaling& scaling, Samples wanted,
                       Averaging averaging = Averaging::light);

}  // namespace inkbench
