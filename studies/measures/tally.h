// SPDX-License-Identifier: MIT
// What one view's lines add up to: counts and sums from which every measure follows. In: a prediction and its
// reference. Out: a tally; tallies of several views and scenes pool by addition, so that no ratio is
// averaged.
#pragma once

#include <optional>
#include <span>

#include "pipeline/lines/line_map.h"
#include "pipeline/settings/judge_params.h"
#include "studies/measures/histogram.h"
#include "studies/measures/jaggedness.h"

namespace inkbench {

/// What is compared. All maps have the same size and are not thinned; their borders are ignored.
struct LinesToMeasure {
  const LineMap& prediction;
  const LineMap& reference;                  ///< Tier 1: lines that a drawing must have.
  const LineMap* allowed = nullptr;          ///< Tier 2: lines that it may have.
  std::span<const Polyline> polylines = {};  ///< For jaggedness and bias; tier 1, as a rule.
  double tolerance_px = kTolerancePx;        ///< 0 to 100.
};

/// Sizes of maximum matchings at one tolerance.
struct MatchCounts {
  int64_t matched = 0;  ///< Prediction with tier 1.
  int64_t allowed = 0;  ///< Prediction with both tiers' pixels together; what is left of it is false.

  void add(const MatchCounts& other);
};

struct LineTally {
  int64_t inside_pixels = 0;  ///< Without the border.
  int64_t predicted = 0, referenced = 0;
  MatchCounts at_tolerance, at_1px, at_diagonal;
  Histogram to_reference;   ///< Squared distances of the prediction's pixels to the reference.
  Histogram to_prediction;  ///< And the other way round.
  double baddeley_sum = 0;  ///< Of squared differences of truncated distances, over the inside pixels.
  int64_t gaps = 0, gap_pixels = 0;
  int64_t components = 0, ends = 0;
  Histogram to_background;  ///< Squared, of the thinned prediction's pixels in the unthinned one.
  LineOffsets offsets;

  /// Neither has a line.
  bool empty() const { return predicted == 0 && referenced == 0; }
  /// Pools. An empty tally is left out.
  void add(const LineTally& other);
};

/// Measures one view. Sizes must be the same.
LineTally tally_lines(const LinesToMeasure& lines);

/// What counts of a line map: its border set to false, then thinned.
LineMap counted_lines(const LineMap& map);

/// A share that pools by adding both numbers.
struct ShareCounts {
  int64_t matched = 0, total = 0;

  void add(const ShareCounts& other);
  /// 0 to 1; none of nothing.
  std::optional<double> share() const;
};

/// The recall over one class of lines: the maximum matching of the prediction with them, as if there were no
/// others. The maps are not thinned.
ShareCounts tally_recall(const LineMap& prediction, const LineMap& class_lines, double tolerance_px);

/// What an F at one tolerance is made of, where no other measure is wanted. Pools by addition.
struct F1Counts {
  int64_t predicted = 0, referenced = 0;
  MatchCounts at_tolerance;

  void add(const F1Counts& other);
};

F1Counts tally_f1(const LinesToMeasure& lines);

/// Reference lines against which many predictions are measured: thinned once.
struct CountedReference {
  LineMap wanted, both_tiers;
};
CountedReference counted_reference(const LineMap& reference, const LineMap* allowed);
/// The same counts. Sizes must be the same.
F1Counts tally_f1(const LineMap& prediction, const CountedReference& reference, double tolerance_px);

/// The F: 1 where neither has a line, 0 where one has none.
double f1_of(const F1Counts& counts);

}  // namespace inkbench
