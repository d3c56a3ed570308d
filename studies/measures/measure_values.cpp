// SPDX-License-Identifier: MIT
#include "studies/measures/measure_values.h"

#include <algorithm>
#include <cmath>

#include "studies/measures/distance.h"

namespace inkbench {
namespace {

double ratio(double part, double whole) {
  return whole == 0 ? 0 : part / whole;
}

double ratio(int64_t part, int64_t whole) {
  return ratio(static_cast<double>(part), static_cast<double>(whole));
}

double root(int64_t squared) {
  return squared == kInfinitelyFar ? INFINITY : std::sqrt(static_cast<double>(squared));
}

double truncated_root(int64_t squared) {
  return std::min<double>(root(squared), kNearLimitPx);
}

double thickness(int64_t squared) {
  return 2 * root(squared) - 1;
}

}  // namespace

MeasureValue precision_of(const DrawingTally& tally) {
  const LineTally& lines = tally.lines;
  return lines.empty() ? 1 : ratio(lines.at_tolerance.allowed, lines.predicted);
}

MeasureValue recall_of(const DrawingTally& tally) {
  const LineTally& lines = tally.lines;
  return lines.empty() ? 1 : ratio(lines.at_tolerance.matched, lines.referenced);
}

MeasureValue f1_with(const DrawingTally& tally, const MatchCounts& matches) {
  return f1_of({tally.lines.predicted, tally.lines.referenced, matches});
}

MeasureValue chamfer_of(const DrawingTally& tally) {
  const LineTally& lines = tally.lines;
  if (lines.empty()) return 0;
  if (lines.predicted == 0 || lines.referenced == 0) return kNearLimitPx;
  return (lines.to_reference.mean(truncated_root) + lines.to_prediction.mean(truncated_root)) / 2;
}

MeasureValue hd95_of(const DrawingTally& tally) {
  const LineTally& lines = tally.lines;
  const double distance =
      std::max(lines.to_reference.quantile(0.95, root), lines.to_prediction.quantile(0.95, root));
  return std::isinf(distance) ? std::nullopt : std::optional(distance);
}

MeasureValue baddeley_of(const DrawingTally& tally) {
  return std::sqrt(ratio(tally.lines.baddeley_sum, static_cast<double>(tally.lines.inside_pixels)));
}

MeasureValue breaks_of(const DrawingTally& tally) {
  return 100 * ratio(tally.lines.gaps, tally.lines.referenced);
}

MeasureValue mean_gap_of(const DrawingTally& tally) {
  return ratio(tally.lines.gap_pixels, tally.lines.gaps);
}

MeasureValue ends_of(const DrawingTally& tally) {
  return 100 * ratio(tally.lines.ends, tally.lines.predicted);
}

MeasureValue thickness_of(const DrawingTally& tally) {
  return tally.lines.to_background.quantile(0.5, thickness);
}

MeasureValue thickness_variation_of(const DrawingTally& tally) {
  return ratio(tally.lines.to_background.deviation(thickness), tally.lines.to_background.mean(thickness));
}

MeasureValue jaggedness_of(const DrawingTally& tally) {
  const LineOffsets& offsets = tally.lines.offsets;
  if (offsets.samples == 0) return std::nullopt;
  return std::sqrt(offsets.squared_wobble_sum / static_cast<double>(offsets.samples));
}

MeasureValue bias_of(const DrawingTally& tally) {
  const LineOffsets& offsets = tally.lines.offsets;
  if (offsets.samples == 0) return std::nullopt;
  return offsets.sum / static_cast<double>(offsets.samples);
}

MeasureValue ink_share_of(const DrawingTally& tally) {
  return ratio(tally.ink, tally.pixels);
}

}  // namespace inkbench
