// SPDX-License-Identifier: MIT
// What smaller formats do to the buffers, and that the same settings give the same bits.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

/// Whether each sample of `stored` is a level n / 255, and the level nearest to `value`; OpenGL leaves ties
/// open.
testing::AssertionResult is_stored(const Image& stored, const reference::Map& value) {
  for (size_t i = 0; i < stored.samples.size(); ++i) {
    const double level = stored.samples[i] * 255.0;
    if (std::abs(level - std::round(level)) > 1e-4)
      return testing::AssertionFailure() << level << " is no level";
    if (std::abs(level - value.samples[i] * 255.0) > 0.501) {
      return testing::AssertionFailure()
             << "sample " << i << ": level " << level << " for " << value.samples[i] * 255.0;
    }
  }
  return testing::AssertionSuccess();
}

struct Buffers {
  Image normal, depth, normal_edges, depth_edges, combined_edges;
};

Buffers draw(const Settings& settings) {
  Pipeline pipeline;
  return {pipeline.at(settings).raw(BufferName::normal), pipeline.at(settings).raw(BufferName::depth),
          pipeline.at(settings).raw(BufferName::normal_edges),
          pipeline.at(settings).raw(BufferName::depth_edges),
          pipeline.at(settings).raw(BufferName::combined_edges)};
}

Settings stored_as(Precision precision, Settings settings) {
  settings.image.precision = precision;
  return settings;
}

Settings eight_bits(const Settings& settings) {
  return stored_as(Precision::unorm8, settings);
}

/// Whether `stored` is a 16-bit float, but for a float's own last digits, and the nearest to `value`.
testing::AssertionResult is_half(float stored, float value) {
  const float half = glm::unpackHalf1x16(glm::packHalf1x16(stored));
  if (std::abs(stored - half) > 1e-7) return testing::AssertionFailure() << stored << " is no 16-bit float";
  if (std::abs(stored - value) > std::abs(value) / 2048 + 1e-7)
    return testing::AssertionFailure() << stored << " for " << value;
  return testing::AssertionSuccess();
}

/// Level of 24 bits between the planes, with its fraction.
double window_level(double depth, const CameraParams& camera) {
  const double near = camera.near, far = camera.far, z = depth * far;
  const double window =
      is_orthographic(camera) ? (z - near) / (far - near) : far * (z - near) / (z * (far - near));
  return window * 16777215.0;
}

TEST(Precision, eight_bits_round_the_normal_and_depth_maps) {
  const Buffers exact = draw(analytic_scene());
  const Buffers stored = draw(eight_bits(analytic_scene()));
  EXPECT_TRUE(is_stored(stored.normal, reference::to_map(exact.normal)));
  EXPECT_TRUE(is_stored(stored.depth, reference::to_map(exact.depth)));
}

TEST(Precision, eight_bits_round_each_edge_buffer_from_the_one_before) {
  const Settings settings = eight_bits(analytic_scene());
  const Buffers stored = draw(settings);
  EXPECT_TRUE(is_stored(stored.normal_edges, reference::gradient(reference::to_map(stored.normal))));
  EXPECT_TRUE(is_stored(stored.depth_edges, reference::gradient(reference::to_map(stored.depth))));
  const reference::Map sums =
      reference::term_sum(reference::range(reference::to_map(stored.depth_edges)),
                          reference::range(reference::to_map(stored.normal_edges)), settings.combine);
  EXPECT_TRUE(is_stored(stored.combined_edges, reference::combine(sums, settings.combine)));
}

TEST(Precision, eight_bits_draw_lines_that_float_does_not) {
  // One level of depth is nearly enough for a line: a slope that is smooth in float breaks into steps.
  const Buffers exact = draw(paper_scene(160, 120));
  const Buffers stored = draw(eight_bits(paper_scene(160, 120)));
  EXPECT_GT(largest_difference(stored.combined_edges, exact.combined_edges), 0.5);
}

TEST(Precision, half_rounds_normals_and_depths_to_16_bit_floats) {
  const Buffers exact = draw(analytic_scene());
  const Buffers stored = draw(stored_as(Precision::half, analytic_scene()));
  for (size_t i = 0; i < exact.depth.samples.size(); ++i)
    ASSERT_TRUE(is_half(stored.depth.samples[i], exact.depth.samples[i])) << i;
  for (size_t i = 0; i < exact.normal.samples.size(); ++i)
    ASSERT_TRUE(is_half(2 * stored.normal.samples[i] - 1, 2 * exact.normal.samples[i] - 1)) << i;
}

TEST(Precision, depth24_rounds_depths_to_levels_between_the_planes) {
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    Settings settings = analytic_scene();
    settings.camera.projection = projection;
    const Buffers exact = draw(settings);
    const Buffers stored = draw(stored_as(Precision::depth24, settings));
    for (size_t i = 0; i < exact.depth.samples.size(); ++i) {
      if (exact.depth.samples[i] == 1.0F) continue;
      const double level = window_level(stored.depth.samples[i], settings.camera);
      // A float has as many digits as there are levels.
      ASSERT_NEAR(level, window_level(exact.depth.samples[i], settings.camera), 1.5) << i;
      if (projection == CameraProjection::perspective) {
        ASSERT_NEAR(level, std::round(level), 0.2) << i;
      }
    }
  }
}

TEST(Precision, depth24_stores_normals_as_half_does) {
  EXPECT_TRUE(draw(stored_as(Precision::depth24, analytic_scene())).normal ==
              draw(stored_as(Precision::half, analytic_scene())).normal);
}

TEST(Precision, shading_does_not_depend_on_it) {
  Pipeline pipeline;
  const Image exact = pipeline.at(analytic_scene()).raw(BufferName::shaded);
  EXPECT_EQ(largest_difference(pipeline.at(eight_bits(analytic_scene())).raw(BufferName::shaded), exact),
            0.0);
}

TEST(Determinism, two_pipelines_give_the_same_bits) {
  const Settings settings = paper_scene(203, 151);
  Pipeline first;
  Pipeline second;
  second.at(analytic_scene()).raw(BufferName::final);  // what was drawn before leaves no trace
  for (const BufferName buffer : framebuffers()) {
    EXPECT_TRUE(first.at(settings).raw(buffer) == second.at(settings).raw(buffer)) << name_of(buffer);
    EXPECT_TRUE(first.at(settings).picture(buffer) == second.at(settings).picture(buffer)) << name_of(buffer);
  }
}

TEST(Determinism, returning_to_earlier_settings_gives_the_same_bits) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  const Image before = pipeline.at(settings).raw(BufferName::final);
  Settings other = settings;
  other.camera.eye.x += 1.0F;
  other.combine.k_depth = 0.01F;
  pipeline.at(other).raw(BufferName::final);
  EXPECT_TRUE(pipeline.at(settings).raw(BufferName::final) == before);
}

}  // namespace
}  // namespace inkbench
