// SPDX-License-Identifier: MIT
// The colours of charts: a path through OKLab along which lightness changes evenly, so that order survives
// printing in grey and every kind of colour vision. Out: "#rrggbb".
#pragma once

#include <string>
#include <vector>

namespace inkbench {

/// Lightness (0 to 1), chroma and hue (degrees) in OKLab's polar form (Ottosson 2020).
struct OkLch {
  double lightness = 0, chroma = 0, hue_deg = 0;
};

/// The colour as sRGB; one outside its gamut loses chroma, never lightness.
std::string srgb_text(OkLch colour);

/// `count` colours for curves on white, from dark blue through red to amber.
std::vector<std::string> curve_colours(size_t count);

/// The stops of a heat map's scale at even distances, from nearly white to dark blue.
std::vector<std::string> heat_colours();

}  // namespace inkbench
