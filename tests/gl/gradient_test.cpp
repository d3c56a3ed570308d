// SPDX-License-Identifier: MIT
// The gradient pass against 3.4.3 on uploaded maps.
#include "pipeline/passes/edges/gradient.h"

#include <cmath>

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"

namespace inkbench {
namespace {

// Twelve float terms of at most 1 are added: each addition rounds by at most 6e-8.
constexpr double kGradientRounding = 1e-6;

Image run_gradient(const Image& normal, const Image& depth) {
  const GeneratedSources generated = generated_sources();
  const GradientPass pass(generated);
  return pass.run(to_texture(with_depth(normal, depth)), Precision::float32).read(0, 2);
}

Image plane_of(const Image& image, int channel) {
  return make_image(image.width_px, image.height_px, [&](int x, int y) { return image.at(x, y, channel); });
}

Image depth_gradient(const Image& depth) {
  return plane_of(run_gradient(Image(depth.width_px, depth.height_px, 3, 0.5F), depth), 0);
}

struct Size {
  int width_px, height_px;
};

class GradientSizes : public testing::TestWithParam<Size> {};

TEST_P(GradientSizes, equals_reference_on_noise) {
  const auto [width, height] = GetParam();
  const Image normal = noise(width, height, 3, 1);
  const Image depth = noise(width, height, 1, 2);
  const Image result = run_gradient(normal, depth);
  EXPECT_TRUE(is_near(plane_of(result, 0), reference::gradient(reference::to_map(depth)), kGradientRounding));
  EXPECT_TRUE(
      is_near(plane_of(result, 1), reference::gradient(reference::to_map(normal)), kGradientRounding));
}

INSTANTIATE_TEST_SUITE_P(Odd, GradientSizes,
                         testing::Values(Size{1, 1}, Size{2, 3}, Size{3, 2}, Size{1, 7}, Size{7, 1},
                                         Size{317, 203}),
                         [](const auto& test) {
                           return std::to_string(test.param.width_px) + "x" +
                                  std::to_string(test.param.height_px);
                         });

TEST(Gradient, ignores_flat_maps) {
  const Image result = run_gradient(Image(19, 13, 3, 0.7F), Image(19, 13, 1, 0.3F));
  for (const float value : result.samples) EXPECT_EQ(value, 0.0F);
}

TEST(Gradient, equals_reference_on_a_step) {
  const Image depth = make_image(16, 12, [](int x, int y) { return 2 * x + y > 17 ? 0.8 : 0.3; });
  EXPECT_TRUE(
      is_near(depth_gradient(depth), reference::gradient(reference::to_map(depth)), kGradientRounding));
}

TEST(Gradient, of_a_ramp_is_half_of_both_slopes_and_of_the_larger) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = degrees * 3.14159265358979 / 180.0;
    const double a = 0.01 * std::cos(angle);
    const double b = 0.01 * std::sin(angle);
    const Image g =
        depth_gradient(make_image(21, 17, [&](int x, int y) { return 0.5 + a * (x - 10) + b * (y - 8); }));
    // The weights of 3.4.3 on a plane: (4|a| + 4|b| + 2|a+b| + 2|a-b|) / 8.
    const double expected = (std::abs(a) + std::abs(b) + std::max(std::abs(a), std::abs(b))) / 2.0;
    for (int y = 1; y < 16; ++y) {
      for (int x = 1; x < 20; ++x)
        ASSERT_NEAR(g.at(x, y), expected, kGradientRounding) << degrees << " degrees";
    }
  }
}

TEST(Gradient, normal_edges_average_the_three_channels) {
  for (int channel = 0; channel < 3; ++channel) {
    Image normal(8, 4, 3, 0.5F);
    for (int y = 0; y < 4; ++y) {
      for (int x = 4; x < 8; ++x) normal.at(x, y, channel) = 0.8F;
    }
    const Image result = run_gradient(normal, Image(8, 4, 1, 1.0F));
    EXPECT_NEAR(result.at(3, 2, 1), 0.3 / 2.0 / 3.0, kGradientRounding) << channel;
    EXPECT_EQ(result.at(3, 2, 0), 0.0F);
  }
}

TEST(Gradient, repeats_the_border_outside_the_image) {
  // A flat map shows an edge if what is outside counts as 0.
  for (const float value : run_gradient(Image(9, 7, 3, 0.7F), Image(9, 7, 1, 0.7F)).samples)
    ASSERT_EQ(value, 0.0F);
  // On a ramp of slope 1/16 the three outer neighbours add nothing: (1 + 2 + 1)/8. Wrapping around would give
  // about half of the whole ramp's height, mirroring 1, zeros another value on each row.
  const Image across = depth_gradient(make_image(12, 7, [](int x, int) { return 0.25 + x / 16.0; }));
  for (const int x : {0, 11}) EXPECT_NEAR(across.at(x, 3), 0.5 / 16.0, kGradientRounding) << x;
  EXPECT_NEAR(across.at(5, 0), 1.0 / 16.0, kGradientRounding);
  EXPECT_NEAR(across.at(5, 6), 1.0 / 16.0, kGradientRounding);
  const Image down = depth_gradient(make_image(7, 12, [](int, int y) { return 0.25 + y / 16.0; }));
  for (const int y : {0, 11}) EXPECT_NEAR(down.at(3, y), 0.5 / 16.0, kGradientRounding) << y;
}

}  // namespace
}  // namespace inkbench
