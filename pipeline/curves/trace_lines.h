// SPDX-License-Identifier: MIT
// Drawn lines as curves. In: lines one pixel wide, as any detector's placed lines are. Out: even curves with
// classes, junctions and rings.
#pragma once

#include "pipeline/curves/curve.h"
#include "pipeline/curves/line_pixels.h"

namespace inkbench {

/// Every point lies within `reach_px` of its pixel's centre, so that curves stay as near to the line through
/// the centres, and every line pixel as near to a curve. Chains are those of `chain_pixels`; each is parted
/// where its class or object changes for good (`steady_labels`; end `other_class`). Curves that end on
/// another one end on its course. A pixel alone becomes a curve of at most a tenth of a pixel, since dots
/// belong to a drawing; `stroke.shortest` leaves them out. Of the outline classes `behind` is what most
/// pixels say. Depends on nothing but the pixels.
Curves trace_lines(const LinePixels& lines, float reach_px);

}  // namespace inkbench
