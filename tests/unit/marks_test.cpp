// SPDX-License-Identifier: MIT
// Marks against drawings whose right answer is known.
#include "studies/measures/marks.h"

#include <gtest/gtest.h>

#include "studies/measures/measures.h"

namespace inkbench {
namespace {

constexpr int kWide = 40, kHigh = 30;

/// A horizontal stroke over columns 10 to 29.
LineMap stroke(int y, int thickness_px = 1) {
  LineMap map(kWide, kHigh);
  for (int row = y; row < y + thickness_px; ++row) {
    for (int x = 10; x < 30; ++x) map.set(x, row);
  }
  return map;
}

LineMap nothing() {
  return {kWide, kHigh};
}

MarkTally tally(const MarkMaps& marks, const LineMap& drawn) {
  return tally_marks(counted_marks(marks), drawn);
}

TEST(Marks, a_wanted_mark_is_found_up_to_3_px_from_a_line) {
  const MarkMaps marks{stroke(10), nothing(), nothing()};
  EXPECT_EQ(tally(marks, stroke(13)).wanted.share(), 1.0);
  EXPECT_EQ(tally(marks, stroke(14)).wanted.share(), 0.0);
}

TEST(Marks, a_broad_wanted_mark_counts_along_its_middle) {
  const MarkMaps marks{stroke(8, 9), nothing(), nothing()};
  const MarkTally on_it = tally(marks, stroke(12));
  EXPECT_EQ(on_it.wanted.share(), 1.0);
  EXPECT_LE(on_it.wanted.total, 20);
  EXPECT_EQ(tally(marks, stroke(17)).wanted.matched, 0) << "5 px from its middle";
}

TEST(Marks, of_an_unwanted_mark_only_what_was_drawn_counts) {
  const MarkMaps marks{nothing(), stroke(5, 11), stroke(10)};
  const MarkTally now = tally(marks, stroke(10));
  EXPECT_EQ(now.unwanted.total, 20);
  EXPECT_EQ(now.unwanted.share(), 0.0);
  EXPECT_EQ(tally(marks, stroke(14)).unwanted.share(), 1.0) << "a new line under the mark is another line";
}

TEST(Marks, an_unwanted_line_is_gone_from_2_px_on) {
  const MarkMaps marks{nothing(), stroke(10), stroke(10)};
  EXPECT_EQ(tally(marks, stroke(11)).unwanted.share(), 0.0);
  EXPECT_EQ(tally(marks, stroke(12)).unwanted.share(), 1.0);
}

TEST(Marks, the_value_is_the_harmonic_mean_and_one_kind_alone_stands_for_itself) {
  EXPECT_DOUBLE_EQ(*(MarkTally{{1, 2}, {4, 4}}).value(), 2.0 / 3);
  EXPECT_EQ((MarkTally{{0, 2}, {0, 4}}).value(), 0.0);
  EXPECT_EQ((MarkTally{{1, 2}, {}}).value(), 0.5);
  EXPECT_EQ((MarkTally{{}, {1, 4}}).value(), 0.25);
  EXPECT_EQ(MarkTally{}.value(), std::nullopt);
}

TEST(Marks, drawings_pool_by_addition_and_views_without_marks_add_nothing) {
  DrawingTally sum, first, second;
  first.marks = MarkTally{{1, 10}, {2, 2}};
  second.marks = MarkTally{{9, 30}, {0, 6}};
  for (const DrawingTally& view : {first, DrawingTally{}, second}) sum.add(view);
  EXPECT_EQ(find_measure("marks_wanted")->value(sum), 10.0 / 40);
  EXPECT_EQ(find_measure("marks_unwanted")->value(sum), 2.0 / 8);
}

TEST(Marks, strokes_are_told_apart_and_judged_by_most_of_them) {
  LineMap wanted = stroke(5), drawn = stroke(5);
  for (int x = 10; x < 30; ++x) wanted.set(x, 20);
  for (int x = 10; x < 19; ++x) drawn.set(x, 20);
  for (int x = 16; x < 30; ++x) drawn.set(x, 20, false);
  const std::vector<MarkedStroke> strokes = look_at_strokes({wanted, stroke(12), stroke(12)}, drawn);
  ASSERT_EQ(strokes.size(), 3);
  EXPECT_TRUE(strokes[0].is_wanted && strokes[0].is_satisfied());
  EXPECT_TRUE(strokes[1].is_wanted && !strokes[1].is_satisfied());
  EXPECT_TRUE(!strokes[2].is_wanted && strokes[2].is_satisfied());
  EXPECT_EQ(strokes[1].centre, (Pixel{19, 20}));
}

TEST(Marks, no_reference_lines_are_asked_for) {
  for (const char* key : {"marks", "marks_wanted", "marks_unwanted"}) {
    MeasureNeeds needs;
    needs.add(*find_measure(key));
    EXPECT_FALSE(needs.reference_lines()) << key;
    EXPECT_TRUE(needs.marks) << key;
  }
}

}  // namespace
}  // namespace inkbench
