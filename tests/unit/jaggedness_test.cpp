// SPDX-License-Identifier: MIT
// Offsets along polylines against sampling the ink finely, and against lines whose offsets are known.
#include "studies/measures/jaggedness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace inkbench {
namespace {

Polyline line(std::vector<glm::vec2> points) {
  return {.line_class = LineClass::silhouette, .object_id = 1, .points = std::move(points)};
}

double jaggedness(const LineOffsets& offsets) {
  return std::sqrt(offsets.squared_wobble_sum / static_cast<double>(offsets.samples));
}

double bias(const LineOffsets& offsets) {
  return offsets.sum / static_cast<double>(offsets.samples);
}

LineMap horizontal_band(int first_row, int rows) {
  LineMap map(200, 60);
  for (int y = first_row; y < first_row + rows; ++y) {
    for (int x = 0; x < 200; ++x) map.set(x, y);
  }
  return map;
}

std::optional<double> sampled_offset(const LineMap& ink, double x, double y, double nx, double ny) {
  constexpr int kSamples = 200000;
  double sum = 0;
  int count = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double t = -4 + 8 * (i + 0.5) / kSamples;
    const int px = static_cast<int>(std::floor(x + t * nx)), py = static_cast<int>(std::floor(y + t * ny));
    if (!ink.contains(px, py) || !ink.at(px, py)) continue;
    sum += t;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

TEST(Jaggedness, offset_is_the_exact_centroid) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(1, 39), angle(0, 6.3);
  LineMap ink(40, 40);
  std::bernoulli_distribution is_line(0.3);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) ink.set(x, y, is_line(random));
  }
  for (int round = 0; round < 100; ++round) {
    const double x = place(random), y = place(random), a = angle(random);
    const std::optional<double> exact = ink_offset(ink, x, y, std::cos(a), std::sin(a));
    const std::optional<double> sampled = sampled_offset(ink, x, y, std::cos(a), std::sin(a));
    ASSERT_EQ(exact.has_value(), sampled.has_value());
    if (exact) {
      EXPECT_NEAR(*exact, *sampled, 2e-4) << x << ' ' << y << ' ' << a;
    }
  }
}

TEST(Jaggedness, straight_line_has_none_and_its_offset_is_the_bias) {
  const LineMap ink = horizontal_band(30, 3);  // its middle lies at y = 31.5
  const LineOffsets centred = line_offsets(ink, std::vector{line({{10, 31.5}, {190, 31.5}})});
  EXPECT_EQ(centred.samples, 181);
  EXPECT_NEAR(bias(centred), 0, 1e-9);
  EXPECT_NEAR(jaggedness(centred), 0, 1e-9);
  const LineOffsets above = line_offsets(ink, std::vector{line({{10, 30.25}, {190, 30.25}})});
  EXPECT_NEAR(bias(above), 1.25, 1e-6);  // ink to the right of travel, which is down
  EXPECT_NEAR(jaggedness(above), 0, 1e-6);
  const LineOffsets back = line_offsets(ink, std::vector{line({{190, 30.25}, {10, 30.25}})});
  EXPECT_NEAR(bias(back), -1.25, 1e-6);
}

TEST(Jaggedness, vertical_and_diagonal_lines_are_measured_along_their_normal) {
  LineMap vertical(60, 200), diagonal(200, 200);
  for (int i = 0; i < 200; ++i) {
    vertical.set(30, i);
    for (int dx = -1; dx <= 1; ++dx) diagonal.set(std::clamp(i + dx, 0, 199), i);
  }
  const LineOffsets down = line_offsets(vertical, std::vector{line({{29.5, 20}, {29.5, 180}})});
  EXPECT_NEAR(bias(down), -1, 1e-9);  // travelling down, the picture's right is to the left of travel
  EXPECT_NEAR(jaggedness(down), 0, 1e-9);
  const LineOffsets slanted = line_offsets(diagonal, std::vector{line({{20.5, 20.5}, {180.5, 180.5}})});
  EXPECT_NEAR(bias(slanted), 0, 0.02);
  EXPECT_LT(jaggedness(slanted), 0.4);
}

TEST(Jaggedness, zigzag_counts_and_slow_drift_does_not) {
  LineMap zigzag(400, 60), drift(400, 60);
  for (int x = 0; x < 400; ++x) {
    zigzag.set(x, 30 + x % 2);
    drift.set(x, 30 + (x > 130) + (x > 260));
  }
  const std::vector<Polyline> lines = {line({{10.5, 30.5}, {390.5, 30.5}})};
  // Of 15 alternating samples 8 lie on the other side, so the mean is 1/30 off the middle.
  EXPECT_NEAR(jaggedness(line_offsets(zigzag, lines)), 0.5 + 1.0 / 30, 0.001);
  EXPECT_LT(jaggedness(line_offsets(drift, lines)), 0.15);
  EXPECT_NEAR(bias(line_offsets(zigzag, lines)), 0.5, 0.01);
}

/// Moving means by hand: offsets 0 ... 0 3 0 ... 0, the peak within reach of 15 samples.
TEST(Jaggedness, moving_mean_is_over_fifteen_samples_and_shorter_at_ends) {
  LineMap ink(60, 40);
  for (int x = 0; x < 60; ++x) ink.set(x, x == 24 ? 23 : 20);
  const LineOffsets offsets = line_offsets(ink, std::vector{line({{4.5, 20.5}, {44.5, 20.5}})});
  ASSERT_EQ(offsets.samples, 41);
  const double expected = 14 * (3.0 / 15) * (3.0 / 15) + (3 - 3.0 / 15) * (3 - 3.0 / 15);
  EXPECT_NEAR(offsets.squared_wobble_sum, expected, 1e-9);
  const LineOffsets at_end = line_offsets(ink, std::vector{line({{24.5, 20.5}, {44.5, 20.5}})});
  double expected_at_end = (3 - 3.0 / 8) * (3 - 3.0 / 8);
  for (int i = 1; i <= 7; ++i) expected_at_end += 9.0 / ((8 + i) * (8 + i));
  EXPECT_NEAR(at_end.squared_wobble_sum, expected_at_end, 1e-9);
}

TEST(Jaggedness, places_without_ink_and_in_the_border_are_left_out) {
  LineMap ink = horizontal_band(30, 1);
  for (int x = 50; x < 80; ++x) ink.set(x, 30, false);
  const LineOffsets offsets = line_offsets(ink, std::vector{line({{10.5, 30.5}, {99.5, 30.5}})});
  EXPECT_EQ(offsets.samples, 90 - 30);
  EXPECT_EQ(line_offsets(ink, std::vector{line({{-20.5, 30.5}, {9.5, 30.5}})}).samples,
            8);  // x = 2.5 ... 9.5
  EXPECT_EQ(line_offsets(ink, std::vector{line({{10.5, 50.5}, {99.5, 50.5}})}).samples, 0);
}

TEST(Jaggedness, arc_length_runs_on_over_corners_and_repeated_points) {
  const LineMap ink = horizontal_band(0, 60);
  const Polyline corner = line({{10, 10}, {13.5, 10}, {13.5, 10}, {13.5, 17}});  // 10.5 px long
  EXPECT_EQ(line_offsets(ink, std::vector{corner}).samples, 11);
  EXPECT_EQ(line_offsets(ink, std::vector{line({{10, 10}, {14, 10}})}).samples, 5);
  EXPECT_EQ(line_offsets(ink, std::vector{line({{10, 10}, {14, 10}, {14, 10}})}).samples, 5)
      << "the last sample is there though the last point is repeated";
  EXPECT_EQ(line_offsets(ink, std::vector{line({{10, 10}, {10, 10}})}).samples, 0);
  EXPECT_EQ(line_offsets(ink, {}).samples, 0);
}

TEST(Jaggedness, pieces_that_reach_infinity_or_are_no_numbers_are_left_out) {
  const LineMap ink = horizontal_band(0, 60);
  const LineOffsets plain = line_offsets(ink, std::vector{line({{10, 10}, {14, 10}})});
  for (const float bad : {INFINITY, -INFINITY, NAN}) {
    for (const glm::vec2 point : {glm::vec2(bad, 10), glm::vec2(14, bad), glm::vec2(bad, -bad)}) {
      const LineOffsets offsets = line_offsets(ink, std::vector{line({{10, 10}, {14, 10}, point, {20, 10}})});
      EXPECT_EQ(offsets.samples, plain.samples);
      EXPECT_EQ(offsets.sum, plain.sum);
    }
  }
}

}  // namespace
}  // namespace inkbench
