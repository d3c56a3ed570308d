// SPDX-License-Identifier: MIT
// The sum behind a pixel, worked out beside the GPU, against what the GPU drew.
#include "pipeline/passes/edges/paper_sum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/pipeline.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

/// Every pixel of the image; returns how many are lines.
int expect_same_as_drawn(Pipeline& pipeline, const Settings& settings) {
  const Image depth_edges = pipeline.at(settings).raw(BufferName::depth_edges);
  const Image normal_edges = pipeline.at(settings).raw(BufferName::normal_edges);
  const Image drawn = pipeline.at(settings).raw(BufferName::combined_edges);
  const bool exact = settings.image.precision == Precision::float32;
  int lines = 0;
  int undecided = 0;
  int different = 0;
  for (int y = 0; y < drawn.height_px; ++y) {
    for (int x = 0; x < drawn.width_px; ++x) {
      const PixelWhy why =
          why_pixel({depth_edges, normal_edges}, settings.combine, x, y, settings.image.precision);
      const float edge = drawn.at(x, y);
      lines += edge != 0.0F;
      // A division may differ in its last digit, which decides within this of the threshold or half a level.
      const float distance = std::abs(why.sum - why.threshold);
      if (distance > 0 && distance < 1e-6F) {
        ++undecided;
        continue;
      }
      different += std::abs(why.edge - edge) > (exact ? 1e-6F : 1.001F / 255.0F);
      if (exact) different += why.inked != (edge != 0.0F);
    }
  }
  EXPECT_EQ(different, 0);
  EXPECT_LE(undecided, 3);
  return lines;
}

TEST(PixelWhyOnGpu, equals_the_paper_scenes_lines_at_every_pixel) {
  Pipeline pipeline;
  Settings settings = paper_scene(257, 193);
  EXPECT_GT(expect_same_as_drawn(pipeline, settings), 1000);
  for (const auto& [k_depth, k_normal, threshold] :
       {std::tuple{0.001F, 0.005F, 0.3F}, {0.01F, 0.1F, 1.2F}, {0.0005F, 0.5F, 0.0F}}) {
    settings.combine = {.k_depth = k_depth, .k_normal = k_normal, .threshold = threshold};
    expect_same_as_drawn(pipeline, settings);
  }
}

TEST(PixelWhyOnGpu, equals_them_with_each_choice_of_terms) {
  Pipeline pipeline;
  Settings settings = paper_scene(257, 193);
  for (const bool use_depth : {false, true}) {
    for (const bool use_normal : {false, true}) {
      settings.combine.use_depth = use_depth;
      settings.combine.use_normal = use_normal;
      const int lines = expect_same_as_drawn(pipeline, settings);
      EXPECT_EQ(lines > 0, use_depth || use_normal);
    }
  }
}

TEST(PixelWhyOnGpu, equals_them_in_eight_bits) {
  Pipeline pipeline;
  Settings settings = paper_scene(257, 193);
  settings.image.precision = Precision::unorm8;
  EXPECT_GT(expect_same_as_drawn(pipeline, settings), 1000);
}

TEST(PixelWhyOnGpu, the_steps_of_a_gradient_are_those_of_the_maps) {
  Pipeline pipeline;
  const Settings settings = paper_scene(257, 193);
  const Image depth_edges = pipeline.at(settings).raw(BufferName::depth_edges);
  const Image normal_edges = pipeline.at(settings).raw(BufferName::normal_edges);
  const Image depth = pipeline.at(settings).raw(BufferName::depth);
  const Image normal = pipeline.at(settings).raw(BufferName::normal);
  const Image object_id = pipeline.at(settings).raw(BufferName::object_id);
  int between_objects = 0;
  for (int y = 0; y < depth.height_px; y += 3) {
    for (int x = 0; x < depth.width_px; x += 3) {
      const PixelWhy why =
          why_pixel({depth_edges, normal_edges, &depth, &normal, &object_id}, settings.combine, x, y);
      if (!why.inked || !why.depth.step) continue;
      const GradientStep& step = *why.depth.step;
      between_objects += step.from_object != step.to_object;
      // The step is one of eight parts of g, with a weight of at most 2 of 8.
      const float weight = step.to.dx != 0 && step.to.dy != 0 ? 1.0F : 2.0F;
      EXPECT_NEAR(weight / 8 * std::abs(step.to_depth - step.from_depth), step.share * why.depth.gmax, 1e-6);
    }
  }
  EXPECT_GT(between_objects, 50);
}

}  // namespace
}  // namespace inkbench
