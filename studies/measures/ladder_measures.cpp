#include "studies/measures/ladder_measures.h"

#include "studies/measures/distance.h"
#include "studies/measures/matching.h"
#include "studies/measures/measures.h"

namespace inkbench {
namespace {

double f1_against(const LineMap& prediction, const LineView& full, double tolerance_px) {
  return measures_of(tally_lines({.prediction = prediction,
                                  .reference = full.wanted,
                                  .allowed = &full.allowed,
                                  .tolerance_px = tolerance_px}))
      .f1;
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

std::optional<double> matched_share(const LineMap& part, const LineMap& other, double tolerance_px) {
  const int64_t count = part.count();
  if (count == 0) return std::nullopt;
  return static_cast<double>(matched_count(part, other, tolerance_px)) / static_cast<double>(count);
}

}  // namespace

LadderMeasures measure_against_full(const LineView& level, const LineView& full, double tolerance_px) {
  LadderMeasures result;
  result.f1_geometry = f1_against(level.wanted, full, tolerance_px);
  result.f1_end_to_end = f1_against(level.drawn, full, tolerance_px);
  const LineMap level_drawn = counted_lines(level.drawn);
  const LineMap full_drawn = counted_lines(full.drawn);
  const LineMap full_inner = inner_pixels(full_drawn, full.outline, tolerance_px);
  const LineMap level_inner = inner_pixels(level_drawn, level.outline, tolerance_px);
  result.internal_kept = matched_share(full_inner, level_drawn, tolerance_px);
  if (const std::optional<double> known = matched_share(level_inner, full_drawn, tolerance_px)) {
    result.internal_new = 1.0 - *known;
  }
  return result;
}

}  // namespace inkbench
