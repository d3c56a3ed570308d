// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "studies/measures/ladder_tally.h"
#include "tests/unit/measured.h"

namespace inkbench {
namespace {

constexpr int kSide = 80;

void draw_vertical(LineMap& map, int x, int from = 10, int to = 70) {
  for (int y = from; y < to; ++y) map.set(x, y);
}

/// An outline at x = 10, drawn, and inner lines drawn at the given columns.
LineView view(const std::vector<int>& inner, int outline = 10) {
  LineView result{LineMap(kSide, kSide), LineMap(kSide, kSide), LineMap(kSide, kSide), LineMap(kSide, kSide)};
  for (LineMap* map : {&result.drawn, &result.wanted, &result.outline}) draw_vertical(*map, outline);
  for (const int x : inner) draw_vertical(result.drawn, x);
  return result;
}

double geometry(const LineView& level, const LineView& full) {
  return f1_of(tally_against_full(level, full).geometry);
}

double end_to_end(const LineView& level, const LineView& full) {
  return f1_of(tally_against_full(level, full).end_to_end);
}

std::optional<double> kept(const LineView& level, const LineView& full) {
  return tally_inner(level, full).kept.share();
}

TEST(LadderTallies, the_full_mesh_against_itself_keeps_all_and_adds_nothing) {
  const LineView full = view({30, 50});
  EXPECT_EQ(geometry(full, full), 1.0);
  EXPECT_EQ(kept(full, full), 1.0);
  EXPECT_EQ(tally_inner(full, full).new_share(), 0.0);
}

TEST(LadderTallies, inner_lines_lost_and_new_are_shares_of_their_own_view) {
  const InnerTally changed = tally_inner(view({30, 60}), view({30, 40, 50}));
  EXPECT_NEAR(*changed.kept.share(), 1.0 / 3, 1e-12);
  EXPECT_NEAR(*changed.new_share(), 1.0 / 2, 1e-12);
}

TEST(LadderTallies, an_inner_line_moved_within_the_tolerance_is_kept) {
  EXPECT_EQ(kept(view({32}), view({30})), 1.0);
  EXPECT_EQ(kept(view({33}), view({30})), 0.0);
}

TEST(LadderTallies, pixels_within_twice_the_tolerance_of_the_outline_are_not_inner) {
  EXPECT_FALSE(kept(view({14}), view({14})).has_value());
  EXPECT_TRUE(kept(view({15}), view({15})).has_value());
  EXPECT_FALSE(tally_inner(view({}), view({})).new_share().has_value());
}

TEST(LadderTallies, moved_outline_is_the_geometrys_loss) {
  EXPECT_EQ(geometry(view({}, 20), view({}, 10)), 0.0);
  EXPECT_EQ(end_to_end(view({}, 20), view({}, 10)), 0.0);
}

TEST(LadderTallies, lines_that_the_full_mesh_allows_are_not_false) {
  LineView full = view({30});
  EXPECT_LT(end_to_end(full, full), 1.0);
  draw_vertical(full.allowed, 30);
  EXPECT_EQ(end_to_end(full, full), 1.0);
}

TEST(LadderTallies, views_pool_by_counts) {
  const LineView one = view({30, 50}), other = view({30, 40, 45, 60}), moved = view({30}, 20);
  InnerTally inner = tally_inner(one, other);
  const InnerTally second = tally_inner(moved, one);
  inner.add(second);
  const double both = static_cast<double>(tally_inner(one, other).kept.matched + second.kept.matched) /
                      static_cast<double>(tally_inner(one, other).kept.total + second.kept.total);
  EXPECT_EQ(inner.kept.share(), both);
  LadderTally ladder = tally_against_full(one, other);
  ladder.add(tally_against_full(moved, other));
  // 1 found of 1 and 0 found of 1, in pixels of equal lines: precision and recall are a half, not their mean.
  EXPECT_NEAR(f1_of(ladder.geometry), 0.5, 1e-12);
}

TEST(LadderTallies, the_f_alone_is_the_f_among_all_measures) {
  LineView one = view({30, 50}), other = view({32, 44}, 11);
  draw_vertical(other.allowed, 50);
  const F1Counts counts =
      tally_f1({.prediction = one.drawn, .reference = other.drawn, .allowed = &other.allowed});
  const Measured all(
      LinesToMeasure{.prediction = one.drawn, .reference = other.drawn, .allowed = &other.allowed});
  EXPECT_EQ(f1_of(counts), all["f1"]);
  EXPECT_EQ(f1_of(F1Counts{}), 1.0);
}

}  // namespace
}  // namespace inkbench
