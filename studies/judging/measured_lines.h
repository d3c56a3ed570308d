// From an image's edges and its reference lines to what the measures compare. In: raw `combined_edges`,
// reference lines. Out: line maps and tallies, the same for a study's cell and for the window.
#pragma once

#include <vector>

#include "pipeline/image/image.h"
#include "pipeline/lines/reference_lines.h"
#include "studies/measures/ladder_measures.h"
#include "studies/measures/measures.h"

namespace inkbench {

/// The pixels above 0 of a raw `combined_edges`, H x W x 1.
LineMap drawn_lines(const Image& combined_edges);

/// The drawn lines with the reference lines of the same view and size.
LineView line_view(const LineMap& drawn, const ReferenceLines& lines);

/// The counts behind all measures of the view; straightness is measured along tier 1 without `object` lines,
/// which are staircases along pixels.
LineTally tally_view(const LineView& view, const ReferenceLines& lines, double tolerance_px = kTolerancePx);

}  // namespace inkbench
