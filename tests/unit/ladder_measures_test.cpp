#include <gtest/gtest.h>

#include "studies/measures/ladder_measures.h"

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

TEST(LadderMeasures, the_full_mesh_against_itself_keeps_all_and_adds_nothing) {
  const LineView full = view({30, 50});
  const LadderMeasures same = measure_against_full(full, full);
  EXPECT_EQ(same.f1_geometry, 1.0);
  EXPECT_EQ(same.internal_kept, 1.0);
  EXPECT_EQ(same.internal_new, 0.0);
}

TEST(LadderMeasures, inner_lines_lost_and_new_are_shares_of_their_own_view) {
  const LadderMeasures changed = measure_against_full(view({30, 60}), view({30, 40, 50}));
  EXPECT_NEAR(*changed.internal_kept, 1.0 / 3, 1e-12);
  EXPECT_NEAR(*changed.internal_new, 1.0 / 2, 1e-12);
}

TEST(LadderMeasures, an_inner_line_moved_within_the_tolerance_is_kept) {
  EXPECT_EQ(measure_against_full(view({32}), view({30})).internal_kept, 1.0);
  EXPECT_EQ(measure_against_full(view({33}), view({30})).internal_kept, 0.0);
}

TEST(LadderMeasures, pixels_within_twice_the_tolerance_of_the_outline_are_not_inner) {
  EXPECT_FALSE(measure_against_full(view({14}), view({14})).internal_kept.has_value());
  EXPECT_TRUE(measure_against_full(view({15}), view({15})).internal_kept.has_value());
  EXPECT_FALSE(measure_against_full(view({}), view({})).internal_new.has_value());
}

TEST(LadderMeasures, moved_outline_is_the_geometrys_loss) {
  const LadderMeasures moved = measure_against_full(view({}, 20), view({}, 10));
  EXPECT_EQ(moved.f1_geometry, 0.0);
  EXPECT_EQ(moved.f1_end_to_end, 0.0);
}

TEST(LadderMeasures, lines_that_the_full_mesh_allows_are_not_false) {
  LineView full = view({30});
  EXPECT_LT(measure_against_full(full, full).f1_end_to_end, 1.0);
  draw_vertical(full.allowed, 30);
  EXPECT_EQ(measure_against_full(full, full).f1_end_to_end, 1.0);
}

}  // namespace
}  // namespace inkbench
