// SPDX-License-Identifier: MIT
// The range pass against 3.4.4 on uploaded gradients.
#include "pipeline/passes/edges/range.h"

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"

namespace inkbench {
namespace {

// One float subtraction of values of at most 1.
constexpr double kRangeRounding = 1e-7;

Image run_range(const Image& gradients) {
  const GeneratedSources generated = generated_sources();
  return RangePass(generated).run(to_texture(gradients)).read(0, 2);
}

reference::Map range_of_channel(const Image& gradients, int channel) {
  return reference::range(reference::to_map(make_image(
      gradients.width_px, gradients.height_px, [&](int x, int y) { return gradients.at(x, y, channel); })));
}

TEST(Range, equals_reference_on_noise_of_any_size) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {3, 2}, {1, 7}, {7, 1}, {317, 203}}) {
    const Image gradients = noise(width, height, 2, 3);
    const Image result = run_range(gradients);
    for (int channel = 0; channel < 2; ++channel) {
      const Image one = make_image(width, height, [&](int x, int y) { return result.at(x, y, channel); });
      EXPECT_TRUE(is_near(one, range_of_channel(gradients, channel), kRangeRounding))
          << width << " x " << height;
    }
  }
}

TEST(Range, spreads_one_pixel_over_its_three_by_three_region) {
  for (const float spike : {0.75F, 0.0F}) {
    Image gradients(9, 9, 2, 0.25F);
    gradients.at(4, 5, 1) = spike;
    const Image result = run_range(gradients);
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) {
        const bool inside = x >= 3 && x <= 5 && y >= 4 && y <= 6;
        EXPECT_EQ(result.at(x, y, 1), inside ? std::abs(spike - 0.25F) : 0.0F) << x << ", " << y;
        EXPECT_EQ(result.at(x, y, 0), 0.0F);
      }
    }
  }
}

TEST(Range, repeats_the_border_outside_the_image) {
  // Zeros outside would give every border pixel of a flat gradient a range; wrapping around would join the
  // sides.
  for (const float value : run_range(Image(9, 7, 2, 0.6F)).samples) ASSERT_EQ(value, 0.0F);
  Image sides(9, 7, 2, 0.25F);
  for (int y = 0; y < 7; ++y) sides.at(8, y, 0) = 0.75F;
  for (int x = 0; x < 9; ++x) sides.at(x, 6, 1) = 0.75F;
  const Image result = run_range(sides);
  EXPECT_EQ(result.at(0, 3, 0), 0.0F);
  EXPECT_EQ(result.at(8, 3, 0), 0.5F);
  EXPECT_EQ(result.at(4, 0, 1), 0.0F);
  EXPECT_EQ(result.at(4, 6, 1), 0.5F);
}

}  // namespace
}  // namespace inkbench
