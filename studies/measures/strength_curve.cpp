// SPDX-License-Identifier: MIT
#include "studies/measures/strength_curve.h"

#include <algorithm>
#include <vector>

namespace inkbench {
namespace {

// ISO C++ has none: products of four counts.
__extension__ using Wide = __int128;

/// F as numerator over denominator: 2 right found / (right referenced + found predicted).
struct Fraction {
  Wide top = 0, bottom = 1;
  bool operator<(const Fraction& other) const { return top * other.bottom < other.top * bottom; }
};

Fraction f_fraction(const StrengthCounts& counts) {
  if (counts.predicted == 0 && counts.referenced == 0) return {1, 1};
  const Wide right = counts.right, found = counts.found;
  if (right == 0 || found == 0) return {0, 1};
  return {2 * right * found, right * counts.referenced + found * counts.predicted};
}

double ratio(int64_t part, int64_t whole, bool both_empty) {
  if (both_empty) return 1;
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

bool nothing_at_all(const StrengthCounts& counts) {
  return counts.predicted == 0 && counts.referenced == 0;
}

struct CurvePointByFound {
  int64_t found = 0;
  double precision = 0;
};

/// By recall, one point for each.
std::vector<CurvePointByFound> points_by_recall(const CurveCounts& curve) {
  std::vector<CurvePointByFound> points;
  for (const StrengthCounts& counts : curve) points.push_back({counts.found, precision_of(counts)});
  const auto less = [](const auto& a, const auto& b) { return a.found < b.found; };
  const auto same = [](const auto& a, const auto& b) { return a.found == b.found; };
  std::stable_sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  return points;
}

}  // namespace

double precision_of(const StrengthCounts& counts) {
  return ratio(counts.right, counts.predicted, nothing_at_all(counts));
}

double recall_of(const StrengthCounts& counts) {
  return ratio(counts.found, counts.referenced, nothing_at_all(counts));
}

double f_of(const StrengthCounts& counts) {
  const double precision = precision_of(counts), recall = recall_of(counts);
  return precision + recall == 0 ? 0 : 2 * precision * recall / (precision + recall);
}

int best_threshold(const CurveCounts& curve) {
  int best = 0;
  for (int i = 1; i < kThresholds; ++i) {
    if (f_fraction(curve[best]) < f_fraction(curve[i])) best = i;
  }
  return best;
}

std::optional<double> average_precision(const CurveCounts& curve) {
  constexpr int kSteps = 100;
  const int64_t referenced = curve[0].referenced;  // at every threshold
  if (referenced == 0) return std::nullopt;
  const std::vector<CurvePointByFound> points = points_by_recall(curve);
  double sum = 0;
  size_t next = 0;
  for (int64_t step = 0; step <= kSteps; ++step) {
    const int64_t wanted = step * referenced;  // in hundredths of a pixel
    while (next < points.size() && kSteps * points[next].found < wanted) ++next;
    if (next == points.size()) break;
    const CurvePointByFound& upper = points[next];
    const bool is_there = kSteps * upper.found == wanted;
    if (is_there) sum += upper.precision;
    if (is_there || next == 0) continue;
    const CurvePointByFound& lower = points[next - 1];
    const double part = static_cast<double>(wanted - kSteps * lower.found) /
                        static_cast<double>(kSteps * (upper.found - lower.found));
    sum += lower.precision + part * (upper.precision - lower.precision);
  }
  return sum / kSteps;
}

void StrengthCurve::add(const CurveCounts& image) {
  add_counts(pooled_, image);
  at_own_best_.add(image[best_threshold(image)]);
}

void StrengthCurve::add(const StrengthCurve& other) {
  add_counts(pooled_, other.pooled_);
  at_own_best_.add(other.at_own_best_);
}

bool StrengthCurve::empty() const {
  return std::all_of(pooled_.begin(), pooled_.end(), nothing_at_all);
}

}  // namespace inkbench
