// SPDX-License-Identifier: MIT
#include "studies/measures/strength_counts.h"

#include <optional>
#include <vector>

#include "studies/measures/near_matching.h"
#include "studies/measures/tally.h"

namespace inkbench {
namespace {

/// One drawing and what is kept of it from threshold to threshold.
class DrawingMatcher {
 public:
  DrawingMatcher(const TieredLines& drawing, double tolerance_px)
      : DrawingMatcher(counted_lines(drawing.wanted), drawing, tolerance_px) {}

  int64_t referenced() const { return wanted_.size(); }

  /// The drawing's pixels that pair. Adds the prediction's that are right to `right`.
  int64_t match(const LineMap& prediction, LineMap& right) {
    if (!both_tiers_) return wanted_.match(prediction, right);
    both_tiers_->match(prediction, right);
    LineMap paired(right.width_px(), right.height_px());
    return wanted_.match(prediction, paired);
  }

 private:
  DrawingMatcher(const LineMap& wanted, const TieredLines& drawing, double tolerance_px)
      : wanted_(wanted, tolerance_px) {
    if (drawing.allowed) both_tiers_.emplace(united(wanted, counted_lines(*drawing.allowed)), tolerance_px);
  }

  NearMatching wanted_;
  std::optional<NearMatching> both_tiers_;
};

StrengthCounts counts_at(const LineMap& prediction, std::vector<DrawingMatcher>& drawings) {
  StrengthCounts counts{.predicted = prediction.count()};
  LineMap right(prediction.width_px(), prediction.height_px());
  for (DrawingMatcher& drawing : drawings) {
    counts.referenced += drawing.referenced();
    counts.found += drawing.match(prediction, right);
  }
  counts.right = right.count();
  return counts;
}

}  // namespace

void StrengthCounts::add(const StrengthCounts& other) {
  predicted += other.predicted;
  right += other.right;
  referenced += other.referenced;
  found += other.found;
}

void add_counts(CurveCounts& sum, const CurveCounts& other) {
  for (int i = 0; i < kThresholds; ++i) sum[i].add(other[i]);
}

CurveCounts count_strengths(const StrengthLevels& levels, std::span<const TieredLines> drawings,
                            double tolerance_px, const StopAsked& stop) {
  std::vector<DrawingMatcher> matchers;
  matchers.reserve(drawings.size());
  for (const TieredLines& drawing : drawings) matchers.emplace_back(drawing, tolerance_px);
  FallingCut cut(levels);
  CurveCounts curve;
  LineMap last(levels.width_px, levels.height_px);
  StrengthCounts counts = counts_at(last, matchers);
  for (int i = kThresholds - 1; i >= 0; --i) {
    stop_if_asked(stop);
    // Many a map holds fewer values than there are thresholds, or thins to the same lines.
    if (cut.grows_at(i)) {
      LineMap prediction = counted_lines(cut.at(i));
      if (prediction != last) counts = counts_at(prediction, matchers);
      last = std::move(prediction);
    }
    curve[i] = counts;
  }
  return curve;
}

}  // namespace inkbench
