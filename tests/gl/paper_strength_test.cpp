// SPDX-License-Identifier: MIT
// The paper's sum as a strength, and ink as the published detectors draw it.
#include "pipeline/passes/edges/paper_strength.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/passes/edges/combine.h"
#include "pipeline/passes/ink/published_look.h"
#include "pipeline/passes/placing/edge_tiles.h"
#include "pipeline/pipeline.h"
#include "tests/gl/detector_support.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

struct PaperDetection {
  Image strength, combined;
};

/// Of ranges that are around the k's.
PaperDetection paper_detection(const CombineParams& params, Image ranges) {
  for (size_t i = 0; i < ranges.samples.size(); ++i)
    ranges.samples[i] *= i % 2 == 0 ? params.k_depth : params.k_normal;
  const GeneratedSources generated = generated_sources();
  const LensBlock lens{20.0F, 0.001F, 0, 0};
  const DetectorMaps maps = noisy_maps(ranges.width_px, ranges.height_px, 2, lens);
  const GBuffer gbuffer{to_texture(with_depth(maps.normal, maps.depth)), to_texture(maps.object_id)};
  const Texture range = to_texture(ranges);
  return {with_classes(PaperStrengthPass(generated).run(params, range), EdgesParams{}.weak, lens, gbuffer),
          CombinePass(generated).run(params, range, Precision::float32).read(0, 1)};
}

TEST(PaperStrength, has_a_class_exactly_where_combined_edges_is_not_0_and_1_at_the_threshold) {
  for (const float threshold : {0.0F, 0.75F, 1.5F}) {
    Image ranges = noise(40, 30, 2, 21, 0.0F, 1.4F);
    for (int i = 0; i < 40; ++i) ranges.samples[i] = 0.0F;  // no sum at all
    const auto [strength, combined] = paper_detection({.threshold = threshold}, ranges);
    int lines = 0;
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        const bool is_line = combined.at(x, y) > 0.0F;
        ASSERT_EQ(strength.at(x, y, 1) != 0.0F, is_line) << threshold << " at " << x << ", " << y;
        ASSERT_EQ(strength.at(x, y, 0) >= 1.0F, is_line) << threshold << " at " << x << ", " << y;
        ASSERT_TRUE(std::isfinite(strength.at(x, y, 0)));
        lines += is_line;
      }
    }
    EXPECT_GT(lines, 20);
    EXPECT_LT(lines, 40 * 30);
  }
}

TEST(PaperStrength, is_the_sum_over_the_threshold) {
  Image ranges(3, 1, 2, 0.0F);
  ranges.at(0, 0, 0) = 0.5F;                       // p = 0.25
  ranges.at(1, 0, 0) = ranges.at(1, 0, 1) = 9.0F;  // each p at most 1
  const Image strength = paper_detection({.threshold = 0.5F}, ranges).strength;
  EXPECT_NEAR(strength.at(0, 0, 0), 0.5, 1e-5);
  EXPECT_NEAR(strength.at(1, 0, 0), 4.0, 1e-5);
  EXPECT_EQ(strength.at(2, 0, 0), 0.0F);
}

TEST(PaperStrength, class_of_an_outline_is_the_objects_over_the_whole_width_of_the_line) {
  Settings settings = small_scene();
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  const Image of = frame.raw(BufferName::edge_class), ids = frame.raw(BufferName::object_id);
  int x = 0;
  while (ids.at(x, 20) == 0.0F) ++x;
  for (const int there : {x - 2, x - 1, x, x + 1})
    EXPECT_EQ(of.at(there, 20), static_cast<float>(EdgeClass::object)) << there - x;
}

/// Without classes.
Image published_look(EdgeMethod method, const Image& detection) {
  const GeneratedSources generated = generated_sources();
  const Texture detected = to_texture(detection);
  const Texture classes = to_texture(Image(detection.width_px, detection.height_px, 1));
  const Texture tiles = EdgeTilesPass(generated).run(1.0F, detected);
  return PublishedLookPass(generated).run(method, detected, classes, tiles).read(0, 1);
}

TEST(PublishedLook, is_half_ink_at_the_limit_and_full_at_twice_the_limit) {
  Image detection(4, 1, 2, 1.0F);
  detection.at(0, 0) = 0.0F;
  detection.at(2, 0) = 2.0F;
  detection.at(3, 0) = 1000.0F;
  for (const EdgeMethod method : {EdgeMethod::decaudin, EdgeMethod::saito_takahashi}) {
    const Image ink = published_look(method, detection);
    const std::array expected{0.0, 0.5, 1.0, 1.0};
    for (int x = 0; x < 4; ++x) EXPECT_NEAR(ink.at(x, 0), expected[x], 0.002);
  }
}

TEST(PublishedLook, makes_mitchells_lines_three_by_three_pixels_wide) {
  Image detection(19, 13, 2);
  detection.at(0, 0, 0) = 0.999F;
  detection.at(8, 4, 0) = 1.0F;  // beside the borders of its tile
  const Image ink = published_look(EdgeMethod::mitchell, detection);
  for (int y = 0; y < 13; ++y) {
    for (int x = 0; x < 19; ++x)
      EXPECT_EQ(ink.at(x, y), std::abs(x - 8) <= 1 && std::abs(y - 4) <= 1 ? 1.0F : 0.0F) << x << ", " << y;
  }
}

}  // namespace
}  // namespace inkbench
