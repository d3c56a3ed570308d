// SPDX-License-Identifier: MIT
// Centre lines for a pen plotter: cut, joined, in short order, in millimetres.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "pipeline/vectors/plot_order.h"
#include "pipeline/vectors/plot_svg.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<PlotLine> scattered_lines(int count) {
  std::vector<PlotLine> lines;
  uint32_t state = 1;
  const auto random = [&] { return ((state = state * 1664525U + 1013904223U) >> 8) / 16777216.0 * 100.0; };
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 at(random(), random());
    if (i % 7 == 0) {
      lines.push_back({at, at + glm::dvec2(3, 0), at + glm::dvec2(3, 3), at});
    } else {
      lines.push_back({at, at + 0.1 * glm::dvec2(random(), random())});
    }
  }
  return lines;
}

/// Each line's points, whichever its direction and wherever a closed one begins.
std::multiset<std::set<std::pair<double, double>>> points_of(const std::vector<PlotLine>& lines) {
  std::multiset<std::set<std::pair<double, double>>> all;
  for (const PlotLine& line : lines) {
    std::set<std::pair<double, double>> points;
    for (const glm::dvec2& point : line) points.emplace(point.x, point.y);
    all.insert(points);
  }
  return all;
}

TEST(PlotLines, line_is_cut_where_it_leaves_the_sheet_and_comes_back) {
  const auto pieces = cut_to_sheet({{{5, 5}, {15, 5}, {15, 8}, {5, 8}}}, {10, 10});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0], (PlotLine{{5, 5}, {10, 5}}));
  EXPECT_EQ(pieces[1], (PlotLine{{10, 8}, {5, 8}}));
}

TEST(PlotLines, line_across_the_sheet_keeps_what_is_inside) {
  EXPECT_EQ(cut_to_sheet({{{-5, 5}, {15, 5}}}, {10, 10}), (std::vector<PlotLine>{{{0, 5}, {10, 5}}}));
  EXPECT_TRUE(cut_to_sheet({{{-5, 5}, {-1, 20}, {50, 20}}}, {10, 10}).empty());
}

TEST(PlotLines, ends_that_coincide_are_drawn_through) {
  const auto joined =
      join_ends({{{0, 0}, {5, 0}}, {{9, 9}, {5, 0.001}}, {{9, 9}, {20, 9}}, {{30, 0}, {40, 0}}}, 0.02);
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_EQ(joined[0].size() + joined[1].size(), 6U);
}

TEST(PlotLines, lines_that_end_where_they_began_are_closed) {
  const auto joined = join_ends({{{0, 0}, {5, 0}}, {{5, 0}, {5, 5}, {0, 0}}}, 0.02);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_TRUE(is_closed(joined[0]));
}

TEST(PlotLines, straightest_pair_goes_on_where_three_meet) {
  const auto joined = join_ends({{{5, 9}, {5, 5}}, {{0, 5}, {5, 5}}, {{5, 5}, {10, 5}}}, 0.02);
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_THAT(joined, testing::Contains(PlotLine{{0, 5}, {5, 5}, {10, 5}}));
}

TEST(PlotOrder, lines_are_the_same_and_travel_is_a_fraction) {
  const std::vector<PlotLine> lines = scattered_lines(150);
  const std::vector<PlotLine> ordered = in_short_order(lines);
  EXPECT_EQ(points_of(ordered), points_of(lines));
  EXPECT_LT(lifted_travel(ordered), 0.2 * lifted_travel(lines));
}

TEST(PlotOrder, no_turn_of_a_part_makes_it_shorter) {
  std::vector<PlotLine> ordered = in_short_order(scattered_lines(40));
  const double travel = lifted_travel(ordered);
  for (size_t first = 0; first < ordered.size(); ++first) {
    for (size_t last = first; last < ordered.size(); ++last) {
      std::vector<PlotLine> turned = ordered;
      std::reverse(turned.begin() + first, turned.begin() + last + 1);
      for (size_t i = first; i <= last; ++i) std::reverse(turned[i].begin(), turned[i].end());
      EXPECT_GE(lifted_travel(turned), travel - 1e-6);
    }
  }
}

TEST(PlotSvg, sheet_is_as_wide_as_asked_and_paths_are_in_millimetres) {
  const PlotDrawing drawing{{{{0, 0}, {100, 0}}, {{200, 50}, {100, 0}}}, {}};
  const Plot plot = plot_svg(drawing, {.width_mm = 50.0}, {200, 100, {}, {}});
  EXPECT_THAT(plot.svg, HasSubstr("width=\"50mm\" height=\"25mm\" viewBox=\"0 0 50 25\""));
  EXPECT_THAT(plot.svg, HasSubstr("d=\"M0 0h25l25 12.5\""));
  EXPECT_EQ(plot.lines, 1U);
}

TEST(PlotSvg, covered_lines_are_a_group_only_where_asked_for) {
  Curves curves{100, 100, {}, {}};
  curves.curves.push_back({.points = {{10, 10}, {90, 10}}});
  curves.curves.push_back({.covered = 1, .points = {{10, 50}, {90, 50}}});
  const PlotDrawing drawing = plot_drawing(curves);
  EXPECT_THAT(plot_svg(drawing, {}, {100, 100, {}, {}}).svg, Not(HasSubstr("hidden")));
  EXPECT_THAT(plot_svg(drawing, {.draws_hidden = true}, {100, 100, {}, {}}).svg,
              HasSubstr("<g id=\"hidden\""));
}

TEST(PlotSvg, file_tells_the_travel_before_and_after) {
  const PlotDrawing drawing{{{{90, 0}, {100, 0}}, {{0, 0}, {10, 0}}}, {}};
  const Plot plot = plot_svg(drawing, {.width_mm = 100.0}, {100, 100, {}, {}});
  EXPECT_NEAR(plot.travel.before, 190.0, 1e-9);
  EXPECT_NEAR(plot.travel.after, 80.0, 1e-9);
  EXPECT_THAT(plot.svg, HasSubstr("2 lines; the pen travels 80 mm lifted, 190 mm in the order"));
}

}  // namespace
}  // namespace inkbench
