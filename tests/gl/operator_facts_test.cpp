// SPDX-License-Identifier: MIT
// Facts about the paper's edge operator that people rely on when they choose k's, thresholds and formats:
// each is true of the passes as they are, and docs may quote it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pipeline/passes/edges/combine.h"
#include "pipeline/passes/edges/gradient.h"
#include "pipeline/passes/edges/range.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"

namespace inkbench {
namespace {

constexpr double kPi = 3.14159265358979;

/// The edge passes on uploaded maps.
struct Edges {
  Image gradient, range, combined;
};

Edges find_edges(const Image& normal, const Image& depth, const CombineParams& params = {}) {
  const GeneratedSources generated = generated_sources();
  const Texture gradient =
      GradientPass(generated).run(to_texture(with_depth(normal, depth)), Precision::float32);
  const Texture range = RangePass(generated).run(gradient);
  const Texture combined = CombinePass(generated).run(params, range, Precision::float32);
  return {gradient.read(0, 2), range.read(0, 2), combined.read(0, 1)};
}

Edges depth_edges(const Image& depth, const CombineParams& params = {}) {
  return find_edges(Image(depth.width_px, depth.height_px, 3, 0.5F), depth, params);
}

Edges normal_edges(const Image& normal, const CombineParams& params = {}) {
  return find_edges(normal, Image(normal.width_px, normal.height_px, 1, 0.5F), params);
}

Image step_of(double base, double height) {
  return make_image(16, 9, [=](int x, int) { return x < 8 ? base : base + height; });
}

bool has_line(const Edges& edges) {
  for (const float value : edges.combined.samples) {
    if (value > 0.0F) return true;
  }
  return false;
}

TEST(OperatorFacts, gradient_of_a_ramp_is_1_00_to_1_12_of_its_length) {
  double smallest = 10.0;
  double largest = 0.0;
  std::vector<double> angles{std::atan(0.5)};  // where it is largest
  for (int degrees = 0; degrees < 360; degrees += 15) angles.push_back(degrees * kPi / 180.0);
  for (const double angle : angles) {
    const double a = 0.01 * std::cos(angle);
    const double b = 0.01 * std::sin(angle);
    const Edges edges =
        depth_edges(make_image(15, 15, [&](int x, int y) { return 0.5 + a * (x - 7) + b * (y - 7); }));
    const double share = edges.gradient.at(7, 7, 0) / 0.01;
    smallest = std::min(smallest, share);
    largest = std::max(largest, share);
  }
  EXPECT_NEAR(smallest, 1.0, 1e-4);
  EXPECT_NEAR(largest, std::sqrt(5.0) / 2.0, 1e-4);  // 1.118
}

TEST(OperatorFacts, step_answers_half_its_height_in_two_columns_and_a_band_4_px_wide) {
  const double height = 0.125;
  const Edges across = depth_edges(step_of(0.25, height));
  const Edges down = depth_edges(make_image(9, 16, [=](int, int y) { return y < 8 ? 0.25 : 0.25 + height; }));
  for (int i = 0; i < 16; ++i) {
    const bool beside = i == 7 || i == 8;
    const bool in_band = i >= 6 && i <= 9;
    for (int j = 0; j < 9; ++j) {
      EXPECT_EQ(across.gradient.at(i, j, 0), beside ? height / 2.0 : 0.0) << i;
      EXPECT_EQ(across.range.at(i, j, 0), in_band ? height / 2.0 : 0.0) << i;
      EXPECT_EQ(down.gradient.at(j, i, 0), beside ? height / 2.0 : 0.0) << i;
      EXPECT_EQ(down.range.at(j, i, 0), in_band ? height / 2.0 : 0.0) << i;
    }
  }
}

/// Lines, and where the sum is too close to the threshold for float arithmetic to decide.
struct Lines {
  Image drawn;
  ImageOf<uint8_t> undecided;
};

Lines lines_of(const Image& ranges, const CombineParams& params) {
  const GeneratedSources generated = generated_sources();
  Lines lines{CombinePass(generated).run(params, to_texture(ranges), Precision::float32).read(0, 1),
              ImageOf<uint8_t>(ranges.width_px, ranges.height_px, 1)};
  for (float& value : lines.drawn.samples) value = value > 0.0F ? 1.0F : 0.0F;
  for (int y = 0; y < ranges.height_px; ++y) {
    for (int x = 0; x < ranges.width_px; ++x) {
      const double sum = std::pow(ranges.at(x, y, 0) / params.k_depth, 2.0) +
                         std::pow(ranges.at(x, y, 1) / params.k_normal, 2.0);
      lines.undecided.at(x, y) = std::abs(sum - params.threshold) < 1e-5;
    }
  }
  return lines;
}

TEST(OperatorFacts, threshold_below_one_and_the_coefficients_are_redundant) {
  Image ranges = noise(200, 150, 2, 7, 0.0F, 0.02F);
  for (size_t i = 0; i < ranges.samples.size(); i += 2) ranges.samples[i] *= 0.25F;
  const CombineParams paper;
  const Lines expected = lines_of(ranges, paper);
  for (const float factor : {0.88F, 1.25F, 3.0F}) {
    // (r / (f k))^2 >= T / f^2 is the same condition as (r / k)^2 >= T.
    const CombineParams other{.k_depth = paper.k_depth * factor,
                              .k_normal = paper.k_normal * factor,
                              .threshold = paper.threshold / (factor * factor)};
    ASSERT_LT(other.threshold, 1.0F);
    EXPECT_TRUE(is_near(lines_of(ranges, other).drawn, expected.drawn, 0.0, &expected.undecided)) << factor;
  }
}

TEST(OperatorFacts, threshold_above_one_is_not_redundant) {
  const Image one_strong_term(1, 1, 2, 0.0F);
  Image ranges = one_strong_term;
  ranges.at(0, 0, 0) = 1.0F;
  const CombineParams high{.threshold = 1.2F};
  EXPECT_EQ(lines_of(ranges, high).drawn.at(0, 0), 0.0F);
  const CombineParams scaled{.k_depth = 0.006F, .k_normal = 0.025F, .threshold = 0.3F};
  EXPECT_EQ(lines_of(ranges, scaled).drawn.at(0, 0), 1.0F);
}

TEST(OperatorFacts, smallest_depth_step_that_shows_is_0_0052) {
  const double smallest = 2.0 * 0.003 * std::sqrt(0.75);
  EXPECT_NEAR(smallest, 0.0052, 5e-5);
  EXPECT_FALSE(has_line(depth_edges(step_of(0.25, smallest * 0.999))));
  EXPECT_TRUE(has_line(depth_edges(step_of(0.25, smallest * 1.001))));
  const CombineParams coarse{.k_depth = 0.012F, .threshold = 0.5F};
  EXPECT_FALSE(has_line(depth_edges(step_of(0.25, 2.0 * 0.012 * std::sqrt(0.5) * 0.999), coarse)));
  EXPECT_TRUE(has_line(depth_edges(step_of(0.25, 2.0 * 0.012 * std::sqrt(0.5) * 1.001), coarse)));
}

/// A step in the normal map; `heights` in x, y and z.
Image normal_step(const std::array<double, 3>& heights) {
  Image normal(16, 9, 3, 0.25F);
  for (int y = 0; y < 9; ++y) {
    for (int x = 8; x < 16; ++x) {
      for (int c = 0; c < 3; ++c) normal.at(x, y, c) = static_cast<float>(0.25 + heights[c]);
    }
  }
  return normal;
}

TEST(OperatorFacts, smallest_average_normal_step_that_shows_is_0_0217) {
  const double smallest = 2.0 * 0.0125 * std::sqrt(0.75);
  EXPECT_NEAR(smallest, 0.0217, 5e-5);
  for (const double factor : {0.999, 1.001}) {
    const double h = smallest * factor;
    EXPECT_EQ(has_line(normal_edges(normal_step({h, h, h}))), factor > 1.0);
    EXPECT_EQ(has_line(normal_edges(normal_step({3.0 * h, 0.0, 0.0}))), factor > 1.0);
    EXPECT_EQ(has_line(normal_edges(normal_step({0.0, 2.0 * h, -h}))), factor > 1.0);
  }
}

TEST(OperatorFacts, one_level_of_eight_bit_depth_gives_p_of_0_43) {
  const CombineParams show_all{.threshold = 0.01F};
  const Edges edges = depth_edges(step_of(100.0 / 255.0, 1.0 / 255.0), show_all);
  EXPECT_NEAR(edges.combined.at(7, 4), 0.43, 0.005);
}

/// Normals across a bend of 90 degrees as the camera above its middle sees them, turning where `turn` (0 to
/// 1) goes.
Image bend(int width_px, const std::function<double(double x)>& turn) {
  Image normal(width_px, 5, 3, 0.5F);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < width_px; ++x) {
      const double angle = (turn(x + 0.5 - width_px / 2.0) - 0.5) * kPi / 2.0;
      normal.at(x, y, 0) = static_cast<float>(0.5 + 0.5 * std::sin(angle));
      normal.at(x, y, 2) = static_cast<float>(0.5 + 0.5 * std::cos(angle));
    }
  }
  return normal;
}

double strongest(const Image& range) {
  double largest = 0.0;
  for (size_t i = 1; i < range.samples.size(); i += 2)
    largest = std::max(largest, static_cast<double>(range.samples[i]));
  return largest;
}

double smooth_bend_answer(double radius_px) {
  const int width = static_cast<int>(radius_px * 16.0);
  return strongest(
      normal_edges(bend(width, [=](double x) { return 0.5 + 0.5 * std::tanh(x / radius_px); })).range);
}

/// An arc of a circle between two flat sides, as a rounded box has it.
double fillet_answer(double radius_px) {
  const double half = radius_px * std::sin(kPi / 4.0);
  const auto turn = [=](double x) {
    return 0.5 +
           std::asin(std::clamp(x / radius_px, -std::sin(kPi / 4.0), std::sin(kPi / 4.0))) / (kPi / 2.0);
  };
  return strongest(normal_edges(bend(static_cast<int>(half * 6.0), turn)).range);
}

TEST(OperatorFacts, smooth_bend_answers_with_the_inverse_square_of_its_radius) {
  for (const double radius : {6.0, 12.0, 24.0}) {
    const double ratio = smooth_bend_answer(radius) / smooth_bend_answer(2.0 * radius);
    EXPECT_GT(ratio, 3.5) << radius;
    EXPECT_LT(ratio, 4.5) << radius;
  }
}

TEST(OperatorFacts, round_fillet_answers_with_the_inverse_of_its_radius) {
  // Where the arc meets the flat side curvature jumps and g with it: first order in 1/R, so such a line fades
  // more slowly than on a bend whose curvature is continuous.
  for (const double radius : {8.0, 16.0, 32.0}) {
    const double ratio = fillet_answer(radius) / fillet_answer(2.0 * radius);
    EXPECT_GT(ratio, 1.7) << radius;
    EXPECT_LT(ratio, 2.5) << radius;
  }
}

/// The strongest normal range on a rendered box whose vertical edge is in the image's middle.
double rendered_box_answer(Shape shape, int side_px) {
  Settings settings;
  settings.image.width = settings.image.height = side_px;
  settings.camera.eye = {0.0F, 0.0F, 3.0F};
  settings.camera.fov = 10.0F;  // the box is larger than the view: its outline is outside
  ModelParams box{.name = "box", .shape = shape, .segments = 48, .fillet = 0.15F};
  box.rotation.y = 45.0F;
  settings.models = {box};
  Pipeline pipeline;
  const Image g = pipeline.at(settings).raw(BufferName::normal_edges);
  const reference::Map range = reference::range(reference::to_map(g));
  return *std::max_element(range.samples.begin(), range.samples.end());
}

TEST(OperatorFacts, crease_answers_the_same_at_any_resolution) {
  const double h = 0.5 * std::sqrt(2.0) / 3.0;  // N.x turns by sqrt(2), one of three channels, 0.5 N + 0.5
  for (const int side_px : {64, 128, 256})
    EXPECT_NEAR(rendered_box_answer(Shape::box, side_px), h / 2.0, 1e-5) << side_px;
}

TEST(OperatorFacts, rounded_edge_fades_at_higher_resolution) {
  const double small = rendered_box_answer(Shape::rounded_box, 64);
  const double large = rendered_box_answer(Shape::rounded_box, 256);
  EXPECT_LT(large, small / 3.0);
}

}  // namespace
}  // namespace inkbench
