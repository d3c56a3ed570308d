// SPDX-License-Identifier: MIT
// ODS, OIS and AP of counts made up by hand.
#include "studies/measures/strength_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "pipeline/base/error.h"
#include "studies/measures/curve_text.h"

namespace inkbench {
namespace {

/// Up to `hundredths` the first counts, from there on the second.
CurveCounts two_steps(int hundredths, const StrengthCounts& low, const StrengthCounts& high) {
  CurveCounts curve;
  for (int i = 0; i < kThresholds; ++i) curve[i] = i < hundredths ? low : high;
  return curve;
}

StrengthCurve curve_of(const std::vector<CurveCounts>& images) {
  StrengthCurve curve;
  for (const CurveCounts& image : images) curve.add(image);
  return curve;
}

/// Any that an image can have: a higher threshold predicts less.
CurveCounts random_counts(uint32_t seed) {
  std::mt19937 random(seed);
  CurveCounts curve;
  StrengthCounts counts{2000, 600, 500, 450};
  for (StrengthCounts& at : curve) {
    counts.right -= static_cast<int64_t>(random() % 5);
    counts.found = std::min<int64_t>(450, counts.right);
    counts.predicted = std::max(counts.right, counts.predicted - static_cast<int64_t>(random() % 30));
    at = counts;
  }
  return curve;
}

TEST(StrengthCurve, ods_is_the_best_f_of_pooled_counts_and_ois_that_of_each_images_best) {
  // Alone: the first is best low with F = 2*10/(10+20), the second high with 1.
  const CurveCounts first = two_steps(50, {10, 10, 20, 10}, {2, 2, 20, 2});
  const CurveCounts second = two_steps(50, {40, 10, 10, 10}, {10, 10, 10, 10});
  const StrengthCurve curve = curve_of({first, second});
  EXPECT_EQ(curve.best(), 50);
  EXPECT_DOUBLE_EQ(curve.ods(), 2.0 * 12 / (12 + 30));
  EXPECT_DOUBLE_EQ(curve.ois(), 2.0 * 20 / (20 + 30));
}

TEST(StrengthCurve, the_lowest_of_equally_good_thresholds_counts) {
  // Both have F = 1/2, from other counts: what is pooled tells which was taken.
  const CurveCounts tied = two_steps(30, {20, 10, 20, 10}, {10, 5, 10, 5});
  const StrengthCurve curve = curve_of({tied});
  EXPECT_EQ(curve.best(), 0);
  EXPECT_EQ(curve.at_own_best(), (StrengthCounts{20, 10, 20, 10}));
}

TEST(StrengthCurve, equal_fs_of_other_counts_are_equal_in_spite_of_rounding) {
  // 2*3*3/(3*7 + 3*3) = 3/5 = 2*21*21/(21*49 + 21*21), which differ in double by the order of operations.
  const CurveCounts tied = two_steps(70, {3, 3, 7, 3}, {21, 21, 49, 21});
  EXPECT_EQ(best_threshold(tied), 0);
}

TEST(StrengthCurve, an_image_with_nothing_in_it_changes_nothing) {
  const CurveCounts image = random_counts(1);
  const StrengthCurve alone = curve_of({image}), with_empty = curve_of({image, CurveCounts{}});
  EXPECT_EQ(with_empty.pooled(), alone.pooled());
  EXPECT_EQ(with_empty.at_own_best(), alone.at_own_best());
}

TEST(StrengthCurve, an_image_without_reference_is_best_where_nothing_is_predicted) {
  const CurveCounts image = two_steps(40, {7, 0, 0, 0}, {0, 0, 0, 0});
  EXPECT_EQ(best_threshold(image), 40);
  EXPECT_EQ(curve_of({image, random_counts(2)}).at_own_best(), curve_of({random_counts(2)}).at_own_best());
}

TEST(StrengthCurve, nothing_on_either_side_is_empty_and_perfect_and_has_no_ap) {
  const StrengthCurve curve = curve_of({CurveCounts{}});
  EXPECT_TRUE(curve.empty());
  EXPECT_EQ(curve.ods(), 1);
  EXPECT_EQ(curve.ois(), 1);
  EXPECT_EQ(curve.ap(), std::nullopt);
}

TEST(StrengthCurve, predictions_without_any_right_one_have_f_0) {
  const StrengthCurve curve = curve_of({two_steps(50, {9, 0, 5, 0}, {4, 0, 5, 0})});
  EXPECT_EQ(curve.ods(), 0);
  EXPECT_EQ(curve.ois(), 0);
  EXPECT_EQ(curve.ap(), 0);
}

TEST(AveragePrecision, runs_linearly_between_recalls_and_is_0_outside) {
  // From (recall 0.2, precision 1) to (0.6, 0.5): 41 recalls on the grid whose mean precision is 0.75.
  const CurveCounts curve = two_steps(50, {12, 6, 10, 6}, {2, 2, 10, 2});
  EXPECT_NEAR(*average_precision(curve), 41 * 0.75 / 100, 1e-12);
}

TEST(AveragePrecision, of_equal_recalls_the_lowest_threshold_counts) {
  CurveCounts curve = two_steps(50, {12, 6, 10, 6}, {2, 2, 10, 2});
  const double before = *average_precision(curve);
  for (int i = 20; i < 50; ++i) curve[i] = {6, 6, 10, 6};  // the same recall at a better precision
  EXPECT_EQ(*average_precision(curve), before);
}

TEST(AveragePrecision, of_one_recall_is_its_precision_over_100_if_it_is_on_the_grid) {
  const StrengthCounts on_grid{2, 1, 2, 1}, off_grid{3, 1, 3, 1};
  EXPECT_EQ(*average_precision(two_steps(50, on_grid, on_grid)), 0.5 / 100);
  EXPECT_EQ(*average_precision(two_steps(50, off_grid, off_grid)), 0);
}

TEST(StrengthCurve, of_one_image_ois_equals_ods_and_ap_lies_within_0_and_1) {
  for (uint32_t seed = 0; seed < 30; ++seed) {
    const StrengthCurve curve = curve_of({random_counts(seed)});
    EXPECT_EQ(curve.ois(), curve.ods());
    EXPECT_GE(*curve.ap(), 0);
    EXPECT_LE(*curve.ap(), 1);
  }
}

TEST(AveragePrecision, of_the_best_that_can_be_is_1) {
  CurveCounts curve;
  for (int i = 0; i < kThresholds; ++i) curve[i] = {100 - i, 100 - i, 100, 100 - i};
  curve.back() = {0, 0, 100, 0};  // recall 0, precision 0
  EXPECT_LE(*average_precision(curve), 1);
  EXPECT_GT(*average_precision(curve), 0.98);
}

TEST(StrengthCurve, the_order_of_images_does_not_matter) {
  std::vector<CurveCounts> images;
  for (uint32_t seed = 0; seed < 5; ++seed) images.push_back(random_counts(seed));
  const StrengthCurve forwards = curve_of(images);
  std::reverse(images.begin(), images.end());
  EXPECT_EQ(curve_of(images).pooled(), forwards.pooled());
  EXPECT_EQ(curve_of(images).at_own_best(), forwards.at_own_best());
}

TEST(CurveText, reads_back) {
  const StrengthCurve curve = curve_of({random_counts(3), random_counts(4)});
  const StrengthCurve again = curve_from_csv(whole_curve_csv(curve), "curve.csv");
  EXPECT_EQ(again.pooled(), curve.pooled());
  EXPECT_EQ(again.at_own_best(), curve.at_own_best());
}

TEST(CurveText, a_row_that_lacks_is_refused) {
  std::string text = whole_curve_csv(curve_of({random_counts(3)}));
  text.erase(text.find("0.50,"), text.find("0.51,") - text.find("0.50,"));
  EXPECT_THROW(curve_from_csv(text, "curve.csv"), Error);
}

}  // namespace
}  // namespace inkbench
