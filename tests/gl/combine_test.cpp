// SPDX-License-Identifier: MIT
// The combine pass against 3.4.4 on uploaded ranges.
#include "pipeline/passes/edges/combine.h"

#include <cmath>

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"

namespace inkbench {
namespace {

// One division, two products and a sum in float, of values of at most 2.
constexpr double kRounding = 1e-6;
constexpr double kNearThreshold = 1e-5;

Image run_combine(const CombineParams& params, const Image& ranges) {
  const GeneratedSources generated = generated_sources();
  return CombinePass(generated).run(params, to_texture(ranges), Precision::float32).read(0, 1);
}

/// Ranges around the paper's k's: channel 0 of depth, channel 1 of normals.
Image noisy_ranges(int width_px, int height_px) {
  Image ranges = noise(width_px, height_px, 2, 4, 0.0F, 1.2F);
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      ranges.at(x, y, 0) *= 0.003F;
      ranges.at(x, y, 1) *= 0.0125F;
    }
  }
  return ranges;
}

reference::Map channel_of(const Image& image, int channel) {
  return reference::to_map(
      make_image(image.width_px, image.height_px, [&](int x, int y) { return image.at(x, y, channel); }));
}

reference::Map sums_of(const CombineParams& params, const Image& ranges) {
  return reference::term_sum(channel_of(ranges, 0), channel_of(ranges, 1), params);
}

/// A sum that equals the threshold is decided: saturated terms are exactly 1.
ImageOf<uint8_t> close_to_threshold(const reference::Map& sums, double threshold) {
  ImageOf<uint8_t> mask(sums.width_px, sums.height_px, 1);
  for (size_t i = 0; i < mask.samples.size(); ++i) {
    const double distance = std::abs(sums.samples[i] - threshold);
    mask.samples[i] = distance > 0.0 && distance < kNearThreshold;
  }
  return mask;
}

void expect_reference(const CombineParams& params, const Image& ranges) {
  const reference::Map sums = sums_of(params, ranges);
  const ImageOf<uint8_t> undecided = close_to_threshold(sums, params.threshold);
  EXPECT_TRUE(is_near(run_combine(params, ranges), reference::combine(sums, params), kRounding, &undecided));
  EXPECT_LT(share_of(undecided), 0.01);
}

TEST(Combine, equals_reference_on_noise_of_any_size) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {317, 203}})
    expect_reference({}, noisy_ranges(width, height));
}

TEST(Combine, equals_reference_for_every_choice_of_terms) {
  const Image ranges = noisy_ranges(64, 48);
  for (const bool use_depth : {false, true}) {
    for (const bool use_normal : {false, true}) {
      for (const float threshold : {0.3F, 0.75F, 1.0F, 1.5F}) {
        expect_reference({.threshold = threshold, .use_depth = use_depth, .use_normal = use_normal}, ranges);
      }
    }
  }
}

TEST(Combine, equals_reference_for_other_coefficients) {
  const Image ranges = noisy_ranges(64, 48);
  for (const float factor : {0.5F, 2.0F})
    expect_reference({.k_depth = 0.003F * factor, .k_normal = 0.0125F / factor}, ranges);
}

TEST(Combine, keeps_a_sum_that_equals_the_threshold) {
  // 3.4.4 rejects values less than the threshold. (0.5/1)^2 + (0.5/1)^2 is exactly 0.5.
  const CombineParams params{.k_depth = 1.0F, .k_normal = 1.0F, .threshold = 0.5F};
  EXPECT_EQ(run_combine(params, Image(1, 1, 2, 0.5F)).at(0, 0), 0.5F);
}

TEST(Combine, draws_nothing_without_terms) {
  const CombineParams params{.use_depth = false, .use_normal = false};
  for (const float value : run_combine(params, Image(5, 5, 2, 1.0F)).samples) EXPECT_EQ(value, 0.0F);
}

TEST(Combine, needs_both_terms_above_a_threshold_of_one) {
  // Each term is at most 1 (the equation's min), however large the range.
  const CombineParams params{.threshold = 1.5F};
  Image ranges(3, 1, 2, 1.0F);
  ranges.at(0, 0, 0) = 0.0F;
  ranges.at(1, 0, 1) = 0.0F;
  const Image edges = run_combine(params, ranges);
  EXPECT_EQ(edges.at(0, 0), 0.0F);
  EXPECT_EQ(edges.at(1, 0), 0.0F);
  EXPECT_EQ(edges.at(2, 0), 1.0F);
}

}  // namespace
}  // namespace inkbench
