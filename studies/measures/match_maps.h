// SPDX-License-Identifier: MIT
// Where drawn lines are right and wrong, as maps. In: a view's lines. Out: thinned pixels of each kind, for
// an overlay.
#pragma once

#include "pipeline/image/image.h"
#include "studies/measures/ladder_tally.h"

namespace inkbench {

/// Disjoint but for missed pixels, which are the reference's: those may lie on drawn ones of another place.
struct MatchMaps {
  LineMap matched;  ///< Drawn pixels that pair with tier 1.
  LineMap allowed;  ///< Drawn pixels that pair with tier 2 only: neither right nor wrong.
  LineMap wrong;    ///< Drawn pixels that pair with neither: as many as precision counts.
  LineMap missed;   ///< Tier 1 pixels that pair with no drawn one.
};

/// By maximum matchings, as the measures use them; borders are left out.
MatchMaps match_maps(const LineView& view, double tolerance_px = kTolerancePx);

/// H x W x 4: the colours of `diff_picture` and grey for allowed, opaque on the lines and clear elsewhere;
/// missed over matched, wrong over missed.
Picture match_overlay(const MatchMaps& maps);

}  // namespace inkbench
