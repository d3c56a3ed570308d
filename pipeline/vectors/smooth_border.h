// SPDX-License-Identifier: MIT
// Staircases along pixels as the smooth borders that they stand for. In: a network of borders along pixels'
// sides. Out: paths that meet where the borders do.
#pragma once

#include "pipeline/vectors/border_network.h"
#include "pipeline/vectors/cubic_path.h"

namespace inkbench {

/// A path for each border. Sharp corners stay; between them the middles of the pixels' sides are evened by a
/// Gaussian, moved by `kMostMoved` px at most, and fitted within `error_px`. Where borders meet, the two that
/// go on straightest are evened as one, and all meet where that leads.
std::vector<CubicPath> smooth_borders(const BorderNetwork& network, double error_px);

inline constexpr double kMostMoved = 1.0;

}  // namespace inkbench
