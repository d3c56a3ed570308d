// SPDX-License-Identifier: MIT
// Strength maps cut at all thresholds and held against drawings: small ones whose counts are plain to see.
#include "studies/measures/strength_counts.h"

#include <gtest/gtest.h>

#include "tests/unit/line_map_support.h"

namespace inkbench {
namespace {

constexpr int kWidth = 40, kHeight = 30;

/// Strength 0 but for rows of 10 px, from x = 10 on.
class StrengthRows {
 public:
  StrengthRows& row(int y, float strength) {
    for (int x = 10; x < 20; ++x) image_.at(x, y) = strength;
    return *this;
  }
  StrengthLevels levels() const { return levels_of(image_); }

 private:
  Image image_{kWidth, kHeight, 1};
};

LineMap drawn_rows(std::initializer_list<int> rows) {
  LineMap map(kWidth, kHeight);
  for (const int y : rows) {
    for (int x = 10; x < 20; ++x) map.set(x, y);
  }
  return map;
}

CurveCounts counted(const StrengthRows& strengths, const std::vector<TieredLines>& drawings) {
  return count_strengths(strengths.levels(), drawings, 2);
}

/// At a threshold in hundredths.
StrengthCounts at(const CurveCounts& curve, int hundredths) {
  return curve[hundredths - 1];
}

TEST(StrengthLevels, each_value_of_8_bits_is_line_where_a_cut_says_so) {
  Image values(256, 1, 1);
  for (int i = 0; i < 256; ++i) values.at(i, 0) = static_cast<float>(i) / 255.0F;
  const StrengthLevels levels = levels_of(values);
  FallingCut cut(levels);
  for (int i = kThresholds - 1; i >= 0; --i)
    ASSERT_EQ(cut.at(i), line_map_from(values, {threshold_of(i), false})) << threshold_of(i);
}

TEST(StrengthLevels, a_float_that_is_a_threshold_reaches_it) {
  Image values(kThresholds, 1, 1);
  for (int i = 0; i < kThresholds; ++i) values.at(i, 0) = static_cast<float>(threshold_of(i));
  const StrengthLevels levels = levels_of(values);
  for (int i = 0; i < kThresholds; ++i) EXPECT_EQ(levels.at(i, 0), i + 1);
}

TEST(StrengthCounts, a_line_is_predicted_up_to_its_strength) {
  const CurveCounts curve = counted(StrengthRows().row(10, 0.6F).row(20, 0.3F), {{drawn_rows({10}), {}}});
  EXPECT_EQ(at(curve, 1), (StrengthCounts{20, 10, 10, 10}));
  EXPECT_EQ(at(curve, 30), (StrengthCounts{20, 10, 10, 10}));
  EXPECT_EQ(at(curve, 31), (StrengthCounts{10, 10, 10, 10}));
  EXPECT_EQ(at(curve, 60), (StrengthCounts{10, 10, 10, 10}));
  EXPECT_EQ(at(curve, 61), (StrengthCounts{0, 0, 10, 0}));
}

TEST(StrengthCounts, right_is_what_any_annotator_drew_and_found_what_each_did) {
  const std::vector<TieredLines> annotators{{drawn_rows({6, 12}), {}}, {drawn_rows({12, 18}), {}}};
  const CurveCounts curve = counted(StrengthRows().row(6, 0.5F).row(12, 0.5F).row(24, 0.5F), annotators);
  EXPECT_EQ(at(curve, 50), (StrengthCounts{30, 20, 40, 30}));
}

TEST(StrengthCounts, several_annotators_count_the_same_in_any_order) {
  std::mt19937 random(5);
  Image strengths(kWidth, kHeight, 1);
  for (float& sample : strengths.samples) sample = static_cast<float>(random() % 100) / 99.0F;
  std::vector<TieredLines> annotators;
  for (int i = 0; i < 3; ++i) annotators.push_back({random_map(kWidth, kHeight, 0.1, random), {}});
  const CurveCounts forwards = count_strengths(levels_of(strengths), annotators, 2.5);
  const std::vector<TieredLines> backwards(annotators.rbegin(), annotators.rend());
  EXPECT_EQ(count_strengths(levels_of(strengths), backwards, 2.5), forwards);
}

TEST(StrengthCounts, allowed_lines_are_right_to_predict_and_need_not_be_found) {
  const CurveCounts curve =
      counted(StrengthRows().row(10, 0.5F).row(20, 0.5F), {{drawn_rows({10}), drawn_rows({20, 26})}});
  EXPECT_EQ(at(curve, 50), (StrengthCounts{20, 20, 10, 10}));
}

TEST(StrengthCounts, an_image_with_nothing_on_either_side_has_no_counts) {
  EXPECT_EQ(counted({}, {{drawn_rows({}), {}}}), CurveCounts{});
}

TEST(StrengthCounts, the_border_of_both_is_left_out) {
  const CurveCounts curve = counted(StrengthRows().row(1, 1.0F), {{drawn_rows({1}), {}}});
  EXPECT_EQ(at(curve, 99), StrengthCounts{});
}

}  // namespace
}  // namespace inkbench
