// SPDX-License-Identifier: MIT
// Precision and recall over thresholds, and the three numbers that sum them up, as contour benchmarks define
// them. In: counts by threshold. Out: ODS, OIS, AP.
// Source: Arbelaez, Maire, Fowlkes and Malik, "Contour detection and hierarchical image segmentation", PAMI
// 33(5), 2011.
#pragma once

#include <optional>

#include "studies/measures/strength_counts.h"

namespace inkbench {

/// 1 where nothing is predicted and nothing referenced, 0 where one of the two is.
double precision_of(const StrengthCounts& counts);
double recall_of(const StrengthCounts& counts);
double f_of(const StrengthCounts& counts);

/// The threshold of the best F, the lowest among equals. F's are compared as fractions, without rounding.
int best_threshold(const CurveCounts& curve);

/// The sum over recalls 0, 1/100, ... 1 of the precision, over 100: linear between the thresholds' recalls
/// (of equal ones that of the lowest threshold), 0 outside of them. None where nothing is referenced.
std::optional<double> average_precision(const CurveCounts& curve);

/// Images, one after the other and in any order.
class StrengthCurve {
 public:
  StrengthCurve() = default;
  /// As an earlier one had them.
  StrengthCurve(const CurveCounts& pooled, const StrengthCounts& at_own_best)
      : pooled_(pooled), at_own_best_(at_own_best) {}

  void add(const CurveCounts& image);
  void add(const StrengthCurve& other);

  const CurveCounts& pooled() const { return pooled_; }
  /// Of each image the counts at its own best threshold, added up.
  const StrengthCounts& at_own_best() const { return at_own_best_; }
  /// Nothing is predicted at any threshold, and nothing referenced.
  bool empty() const;

  int best() const { return best_threshold(pooled_); }
  double ods() const { return f_of(pooled_[best()]); }
  double ois() const { return f_of(at_own_best_); }
  std::optional<double> ap() const { return average_precision(pooled_); }

 private:
  CurveCounts pooled_{};
  StrengthCounts at_own_best_;
};

}  // namespace inkbench
