// SPDX-License-Identifier: MIT
#include "pipeline/vectors/traced_regions.h"

#include <algorithm>
#include <cmath>

#include "pipeline/base/stop.h"
#include "pipeline/vectors/border_network.h"
#include "pipeline/vectors/regions.h"
#include "pipeline/vectors/smooth_border.h"

namespace inkbench {
namespace {

CubicPath scaled(CubicPath path, double scale) {
  path.start *= scale;
  for (PathPiece& piece : path.pieces) {
    piece.leave *= scale;
    piece.enter *= scale;
    piece.end *= scale;
  }
  return path;
}

/// The same way in the other direction.
CubicPath reversed(const CubicPath& path) {
  CubicPath result{path.pieces.back().end, {}, path.is_closed};
  for (size_t i = path.pieces.size(); i-- > 0;) {
    const PathPiece& piece = path.pieces[i];
    const glm::dvec2 start = i == 0 ? path.start : path.pieces[i - 1].end;
    result.pieces.push_back({piece.enter, piece.leave, start, piece.is_line});
  }
  return result;
}

CubicPath ring_path(const BorderRing& ring, const std::vector<CubicPath>& borders) {
  CubicPath path;
  for (const BorderUse& use : ring) {
    const CubicPath part = use.is_backwards ? reversed(borders[use.border]) : borders[use.border];
    if (path.pieces.empty()) path.start = part.start;
    path.pieces.insert(path.pieces.end(), part.pieces.begin(), part.pieces.end());
  }
  path.is_closed = true;
  return path;
}

}  // namespace

std::vector<TracedRegion> traced_regions(const Image& shaded, const Image& object_ids,
                                         const RegionOptions& options) {
  const FlatPicture flat = flat_colours(shaded, object_ids, options.steps);
  const double sample_area = options.sample_px * options.sample_px;
  const Regions regions =
      without_small_regions(flat.numbers, static_cast<int>(std::ceil(options.least_px / sample_area)));
  const BorderNetwork network = border_network(regions.region);
  std::vector<CubicPath> borders = smooth_borders(network, options.error_px / options.sample_px);
  for (CubicPath& border : borders) border = scaled(std::move(border), options.sample_px);
  std::vector<TracedRegion> traced;
  for (size_t i = 0; i < regions.numbers.size(); ++i) {
    TracedRegion& region = traced.emplace_back();
    region.colour = flat.colours[static_cast<size_t>(regions.numbers[i])];
    region.area = regions.areas[i] * sample_area;
    for (const BorderRing& ring : network.rings[i]) region.outlines.push_back(ring_path(ring, borders));
  }
  std::stable_sort(traced.begin(), traced.end(),
                   [](const TracedRegion& one, const TracedRegion& other) { return one.area > other.area; });
  return traced;
}

}  // namespace inkbench
