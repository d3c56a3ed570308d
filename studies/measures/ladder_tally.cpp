// SPDX-License-Identifier: MIT
#include "studies/measures/ladder_tally.h"

#include "studies/measures/distance.h"
#include "studies/measures/matching.h"

namespace inkbench {
namespace {

F1Counts against(const LineMap& prediction, const LineView& full, double tolerance_px) {
  return tally_f1({.prediction = prediction,
                   .reference = full.wanted,
                   .allowed = &full.allowed,
                   .tolerance_px = tolerance_px});
}

LineMap inner_pixels(const LineMap& thinned, const LineMap& outline, double tolerance_px) {
  const int64_t near = squared_tolerance(2 * tolerance_px);
  const std::vector<Pixel> pixels = pixels_of(thinned);
  const std::vector<int64_t> distances = squared_distances(pixels, outline);
  LineMap inner(thinned.width_px(), thinned.height_px());
  for (size_t i = 0; i < pixels.size(); ++i) {
    if (distances[i] > near) inner.set(pixels[i].x, pixels[i].y);
  }
  return inner;
}

ShareCounts matched_share(const LineMap& part, const LineMap& other, double tolerance_px) {
  return {matched_count(part, other, tolerance_px), part.count()};
}

}  // namespace

void LadderTally::add(const LadderTally& other) {
  geometry.add(other.geometry);
  end_to_end.add(other.end_to_end);
}

LadderTally tally_against_full(const LineView& level, const LineView& full, double tolerance_px) {
  return {against(level.wanted, full, tolerance_px), against(level.drawn, full, tolerance_px)};
}

void InnerTally::add(const InnerTally& other) {
  kept.add(other.kept);
  known.add(other.known);
}

std::optional<double> InnerTally::new_share() const {
  const std::optional<double> share = known.share();
  return share ? std::optional(1.0 - *share) : std::nullopt;
}

InnerTally tally_inner(const LineView& level, const LineView& full, double tolerance_px) {
  const LineMap level_drawn = counted_lines(level.drawn), full_drawn = counted_lines(full.drawn);
  const LineMap full_inner = inner_pixels(full_drawn, full.outline, tolerance_px);
  const LineMap level_inner = inner_pixels(level_drawn, level.outline, tolerance_px);
  return {matched_share(full_inner, level_drawn, tolerance_px),
          matched_share(level_inner, full_drawn, tolerance_px)};
}

}  // namespace inkbench
