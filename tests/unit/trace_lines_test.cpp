// SPDX-License-Identifier: MIT
// Drawn lines traced into curves: what is joined, how far curves leave the pixels, where they are parted.
#include "pipeline/curves/trace_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string_view>

#include "pipeline/lines/line_map.h"
#include "pipeline/lines/thinning.h"
#include "tests/traced_support.h"

namespace inkbench {
namespace {

constexpr float kReachPx = 0.75F;

LinePixels pixels_of_map(const LineMap& map, CurveClass curve_class = CurveClass::crease) {
  LinePixels lines{map.width_px(), map.height_px(), {}};
  for_each_pixel(map, [&](int x, int y) {
    lines.pixels.push_back({.x = x, .y = y, .curve_class = curve_class, .object_id = 1});
  });
  return lines;
}

/// A letter for each line pixel, by class: c crease, n normal, s silhouette; '.' for none.
LinePixels drawn(const std::vector<std::string_view>& rows) {
  LinePixels lines{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  for (int y = 0; y < lines.height_px; ++y) {
    for (int x = 0; x < lines.width_px; ++x) {
      const char letter = rows[y][x];
      if (letter == '.') continue;
      const CurveClass curve_class = letter == 'c'   ? CurveClass::crease
                                     : letter == 'n' ? CurveClass::normal
                                                     : CurveClass::silhouette;
      lines.pixels.push_back({.x = x, .y = y, .curve_class = curve_class, .object_id = 1});
    }
  }
  return lines;
}

/// The pixels that have the curve `level(x, y) = 0` between themselves and a neighbour, thinned.
template <class Level>
LineMap contour(int size_px, const Level& level) {
  LineMap map(size_px, size_px);
  for (int y = 1; y + 1 < size_px; ++y) {
    for (int x = 1; x + 1 < size_px; ++x) {
      const auto is_inside = [&](int dx, int dy) { return level(x + dx + 0.5, y + dy + 0.5) < 0.0; };
      if (is_inside(0, 0) && !(is_inside(1, 0) && is_inside(-1, 0) && is_inside(0, 1) && is_inside(0, -1)))
        map.set(x, y);
    }
  }
  return thinned(map);
}

LineMap random_map(int width_px, int height_px, uint32_t seed, uint32_t percent) {
  LineMap map(width_px, height_px);
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      seed = seed * 1664525U + 1013904223U;
      if ((seed >> 8) % 100 < percent) map.set(x, y);
    }
  }
  return map;
}

/// Pixels reached from one to the next where `is_of` says so, by four or eight neighbours.
template <class IsOf>
int count_parts(int width_px, int height_px, bool eight, const IsOf& is_of) {
  std::set<std::pair<int, int>> left;
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      if (is_of(x, y)) left.insert({x, y});
    }
  }
  int parts = 0;
  for (; !left.empty(); ++parts) {
    std::vector<std::pair<int, int>> front{*left.begin()};
    left.erase(left.begin());
    while (!front.empty()) {
      const auto [x, y] = front.back();
      front.pop_back();
      for (int i = 0; i < 9; ++i) {
        const int dx = i % 3 - 1, dy = i / 3 - 1;
        if ((eight || dx == 0 || dy == 0) && left.erase({x + dx, y + dy}) > 0)
          front.emplace_back(x + dx, y + dy);
      }
    }
  }
  return parts;
}

TEST(PixelGraph, has_a_ring_for_each_hole_and_none_besides) {
  for (const uint32_t percent : {10U, 35U, 60U, 90U}) {
    const int width = 40, height = 30;
    LineMap map(width, height);  // with a border that is empty
    for_each_pixel(random_map(width - 2, height - 2, percent, percent),
                   [&](int x, int y) { map.set(x + 1, y + 1); });
    const LinePixels lines = pixels_of_map(map);
    const PixelGraph graph(lines);
    size_t links = 0;
    for (uint32_t i = 0; i < graph.size(); ++i) links += graph.links_of(i).size();
    const int parts = count_parts(width, height, true, [&](int x, int y) { return map.at(x, y); });
    const int holes = count_parts(width, height, false, [&](int x, int y) { return !map.at(x, y); }) - 1;
    EXPECT_EQ(static_cast<int>(links / 2) - static_cast<int>(graph.size()) + parts, holes) << percent;
  }
}

TEST(PixelGraph, chains_use_each_link_once) {
  const LinePixels lines = pixels_of_map(random_map(40, 30, 7, 40));
  const PixelGraph graph(lines);
  std::multiset<std::pair<uint32_t, uint32_t>> used;
  std::set<uint32_t> seen;
  for (const PixelChain& chain : chain_pixels(lines, graph)) {
    seen.insert(chain.pixels.begin(), chain.pixels.end());
    for (size_t i = 1; i < chain.pixels.size(); ++i)
      used.insert(std::minmax(chain.pixels[i - 1], chain.pixels[i]));
  }
  EXPECT_EQ(seen.size(), lines.pixels.size());
  std::multiset<std::pair<uint32_t, uint32_t>> links;
  for (uint32_t i = 0; i < graph.size(); ++i) {
    for (const uint32_t other : graph.links_of(i)) {
      if (i < other) links.insert({i, other});
    }
  }
  EXPECT_EQ(used, links);
}

TEST(TraceLines, curves_stay_within_reach_of_the_thinned_lines_and_these_of_them) {
  const LineMap wavy = contour(64, [](double x, double y) {
    const double angle = std::atan2(y - 32.0, x - 32.0);
    return std::hypot(x - 32.0, y - 32.0) - 20.0 - 7.0 * std::sin(5.0 * angle);
  });
  for (const LineMap& map : {wavy, thinned(random_map(48, 40, 3, 30)), random_map(24, 24, 5, 55)}) {
    LinePixels lines = pixels_of_map(map);
    uint32_t state = 9;
    for (LinePixel& pixel : lines.pixels) {
      state = state * 1664525U + 1013904223U;
      pixel.offset = {static_cast<float>((state >> 8) % 100) / 100.0F - 0.495F,
                      static_cast<float>((state >> 20) % 100) / 100.0F - 0.495F};
    }
    for (const float reach_px : {0.2F, kReachPx}) {
      const Segments curves = segments_of(trace_lines(lines, reach_px));
      EXPECT_LE(farthest(curves, segments_of(lines)), reach_px + 1e-4F);
      EXPECT_LE(farthest(segments_of(lines), curves), reach_px + 1e-4F);
    }
  }
}

TEST(TraceLines, without_reach_are_the_pixels_centres) {
  const LinePixels lines = drawn({"c....", ".c...", "..cc."});
  const Curves curves = trace_lines(lines, 0.0F);
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_EQ(curves.curves[0].points,
            (std::vector<glm::vec2>{{0.5F, 0.5F}, {1.5F, 1.5F}, {2.5F, 2.5F}, {3.5F, 2.5F}}));
}

TEST(TraceLines, a_circle_is_one_even_ring_of_its_own_size) {
  for (const double radius : {4.0, 8.0, 25.0, 60.0}) {
    const glm::vec2 middle(70.3F, 69.6F);
    const LinePixels lines = pixels_of_map(
        contour(140, [&](double x, double y) { return std::hypot(x - middle.x, y - middle.y) - radius; }));
    const Curves curves = trace_lines(lines, kReachPx);
    ASSERT_EQ(curves.curves.size(), 1U) << radius;
    const Curve& ring = curves.curves[0];
    EXPECT_TRUE(ring.is_closed());
    EXPECT_EQ(ring.start, CurveEnd::closed);
    double pixels = 0.0, mean = 0.0, spread = 0.0;
    for (const LinePixel& pixel : lines.pixels) pixels += glm::distance(pixel.centre(), middle);
    for (const glm::vec2& point : ring.points) mean += glm::distance(point, middle);
    mean /= static_cast<double>(ring.points.size());
    for (const glm::vec2& point : ring.points) spread += std::pow(glm::distance(point, middle) - mean, 2.0);
    EXPECT_NEAR(mean, pixels / static_cast<double>(lines.pixels.size()), 0.1) << radius;
    EXPECT_LT(std::sqrt(spread / static_cast<double>(ring.points.size())), 0.15) << radius;
  }
}

TEST(TraceLines, a_gentle_slope_loses_its_steps) {
  LineMap map(120, 30);
  for (int x = 5; x < 115; ++x) map.set(x, 5 + (x - 5) / 8);
  const Curves curves = trace_lines(pixels_of_map(map), kReachPx);
  ASSERT_EQ(curves.curves.size(), 1U);
  const std::vector<glm::vec2>& points = curves.curves[0].points;
  double turned = 0.0, on_pixels = 13 * 2 * std::atan(1.0);  // each step turns there and back by 45 degrees
  for (size_t i = 2; i < points.size(); ++i) {
    const glm::vec2 in = points[i - 1] - points[i - 2], out = points[i] - points[i - 1];
    turned += std::abs(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)));
  }
  EXPECT_LT(turned, 0.05 * on_pixels);
}

TEST(TraceLines, a_line_that_meets_another_ends_on_it) {
  LineMap map(60, 60);
  for (int x = 4; x < 56; ++x) map.set(x, 10 + x / 3);
  for (int y = 21; y < 55; ++y) map.set(30, y);
  const Curves curves = trace_lines(pixels_of_map(map), kReachPx);
  ASSERT_EQ(curves.curves.size(), 2U);
  const Curve& bar = curves.curves[0];
  const Curve& stem = curves.curves[1];
  EXPECT_EQ(bar.start, CurveEnd::free);
  EXPECT_EQ(bar.end, CurveEnd::free);
  const bool starts_there = stem.start == CurveEnd::junction;
  EXPECT_EQ(starts_there ? stem.end : stem.start, CurveEnd::free);
  const glm::vec2 foot = starts_there ? stem.points.front() : stem.points.back();
  EXPECT_TRUE(std::ranges::find(bar.points, foot) != bar.points.end());
}

TEST(TraceLines, lines_that_cross_go_straight_on) {
  LineMap map(61, 61);
  for (int i = 5; i < 56; ++i) {
    map.set(i, 30);
    map.set(30, i);
  }
  const Curves curves = trace_lines(pixels_of_map(map), kReachPx);
  ASSERT_EQ(curves.curves.size(), 2U);
  for (const Curve& curve : curves.curves) EXPECT_EQ(curve.points.size(), 51U);
}

TEST(TraceLines, there_are_as_many_curves_as_separate_lines) {
  LineMap map(80, 80);
  int lines = 0;
  for (int y = 4; y < 76; y += 6, ++lines) {
    for (int x = 4; x < 70; ++x) map.set(x, y + (x * lines) % 3 / 2);
  }
  EXPECT_EQ(trace_lines(pixels_of_map(thinned(map)), kReachPx).curves.size(), static_cast<size_t>(lines));
}

TEST(TraceLines, the_smallest_ring_stays_one) {
  const Curves curves = trace_lines(drawn({".....", "..c..", ".c.c.", "..c..", "....."}), kReachPx);
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_TRUE(curves.curves[0].is_closed());
  EXPECT_GT(length_px(curves.curves[0]), 1.0);
}

TEST(TraceLines, a_pixel_alone_is_a_dot) {
  const Curves curves = trace_lines(drawn({"...", ".c.", "..."}), kReachPx);
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_NEAR(length_px(curves.curves[0]), 0.1, 1e-5);
}

TEST(TraceLines, an_end_on_the_images_border_is_the_frames) {
  const Curves curves = trace_lines(drawn({"......", "ccc...", "......"}), kReachPx);
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_EQ(curves.curves[0].start, CurveEnd::frame);
  EXPECT_EQ(curves.curves[0].end, CurveEnd::free);
}

TEST(TraceLines, a_short_run_of_another_class_is_absorbed) {
  const Curves curves =
      trace_lines(drawn({"................", ".cccccnnnccccccn", "................"}), kReachPx);
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_EQ(curves.curves[0].curve_class, CurveClass::crease);
}

TEST(TraceLines, a_class_that_changes_for_good_parts_a_chain) {
  const Curves curves = trace_lines(
      drawn({"......................", ".cccccccnnnnnnnsssssss", "......................"}), kReachPx);
  ASSERT_EQ(curves.curves.size(), 3U);
  const CurveClass expected[] = {CurveClass::crease, CurveClass::normal, CurveClass::silhouette};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(curves.curves[i].curve_class, expected[i]);
    EXPECT_EQ(curves.curves[i].chain, 0U);
    if (i == 0) continue;
    EXPECT_EQ(curves.curves[i - 1].end, CurveEnd::other_class);
    EXPECT_EQ(curves.curves[i].start, CurveEnd::other_class);
    EXPECT_EQ(curves.curves[i - 1].points.back(), curves.curves[i].points.front());
  }
}

TEST(TraceLines, a_ring_of_two_classes_is_parted_twice) {
  LinePixels lines =
      pixels_of_map(contour(50, [](double x, double y) { return std::hypot(x - 25, y - 25) - 15; }));
  for (LinePixel& pixel : lines.pixels) {
    if (pixel.x > 25) pixel.curve_class = CurveClass::normal;
  }
  const Curves curves = trace_lines(lines, kReachPx);
  ASSERT_EQ(curves.curves.size(), 2U);
  EXPECT_NE(curves.curves[0].curve_class, curves.curves[1].curve_class);
  EXPECT_EQ(curves.curves[0].points.back(), curves.curves[1].points.front());
  EXPECT_EQ(curves.curves[1].points.back(), curves.curves[0].points.front());
}

TEST(TraceLines, an_outline_has_behind_it_what_most_of_its_pixels_say) {
  LinePixels lines = drawn({"..........", ".sssssssss", ".........."});
  for (LinePixel& pixel : lines.pixels) pixel.behind = pixel.x < 3 ? Behind::same_object : Behind::nothing;
  EXPECT_EQ(trace_lines(lines, kReachPx).curves.at(0).behind, Behind::nothing);
  for (LinePixel& pixel : lines.pixels) pixel.curve_class = CurveClass::crease;
  EXPECT_EQ(trace_lines(lines, kReachPx).curves.at(0).behind, Behind::unknown);
}

}  // namespace
}  // namespace inkbench
