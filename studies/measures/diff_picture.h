// SPDX-License-Identifier: MIT
// A picture of where a prediction is right and wrong. In: prediction, reference and the tolerance. Out: an
// RGB picture with a legend below it.
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/lines/line_map.h"

namespace inkbench {

/// On white, one colour each: what the reference's thinned lines miss and what the prediction's thinned lines
/// have right, allowed and wrong, as `match_maps`, and pale grey for the rest of the prediction's ink. The
/// colours (Okabe and Ito's black, blue and vermillion) differ in every form of colour blindness. Where
/// colours meet, false is drawn over missed, missed over matched, matched over allowed. The legend, with
/// counts, is left out where it is wider than the image, and names allowed lines where there is a second
/// tier. H + 24 (or H) x W x 3. Maps of the same size; `allowed` is tier 2.
Picture diff_picture(const LineMap& prediction, const LineMap& reference, double tolerance_px,
                     const LineMap* allowed = nullptr);

inline constexpr int kDiffLegendHeightPx = 24;
inline constexpr std::array<uint8_t, 3> kMatchedColour{0, 0, 0}, kMissedColour{0, 114, 178},
    kFalseColour{213, 94, 0}, kAllowedColour{150, 150, 150};

}  // namespace inkbench
