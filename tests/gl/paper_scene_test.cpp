// SPDX-License-Identifier: MIT
// The whole chain on the paper's scene, rabbit included: each buffer against the CPU reference of the buffers
// before it.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/cpu_shading.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

// Sums of 12 float differences, most of them far below 1.
constexpr double kSceneRounding = 1e-6;

/// All tests of this file look at one drawing.
class PaperScene : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    settings_ = paper_scene(257, 193);
    Pipeline pipeline;
    for (const BufferName buffer : framebuffers()) buffers_[buffer] = pipeline.at(settings_).raw(buffer);
  }
  static const Image& raw(BufferName buffer) { return buffers_[buffer]; }
  static reference::Map map(BufferName buffer) { return reference::to_map(raw(buffer)); }

  static inline Settings settings_;
  static inline PerBuffer<Image> buffers_;
};

TEST_F(PaperScene, shows_all_its_objects) {
  std::array<int, 4> pixels{};
  for (const float id : raw(BufferName::object_id).samples) ++pixels.at(static_cast<size_t>(id));
  EXPECT_EQ(pixels[0], 0) << "the room is closed";
  for (int id = 1; id <= 3; ++id) EXPECT_GT(pixels[id], 500) << id;
}

TEST_F(PaperScene, depth_edges_equal_reference) {
  EXPECT_TRUE(
      is_near(raw(BufferName::depth_edges), reference::gradient(map(BufferName::depth)), kSceneRounding));
}

TEST_F(PaperScene, normal_edges_equal_reference) {
  EXPECT_TRUE(
      is_near(raw(BufferName::normal_edges), reference::gradient(map(BufferName::normal)), kSceneRounding));
}

TEST_F(PaperScene, combined_edges_equal_reference_of_normal_and_depth) {
  const reference::Map sums =
      reference::term_sum(reference::range(reference::gradient(map(BufferName::depth))),
                          reference::range(reference::gradient(map(BufferName::normal))), settings_.combine);
  ImageOf<uint8_t> undecided(sums.width_px, sums.height_px, 1);
  for (size_t i = 0; i < sums.samples.size(); ++i) {
    undecided.samples[i] = std::abs(sums.samples[i] - settings_.combine.threshold) < 1e-5;
  }
  EXPECT_LT(share_of(undecided), 0.001);
  // p magnifies a rounding of the range by up to 2 / k_depth = 670.
  EXPECT_TRUE(is_near(raw(BufferName::combined_edges), reference::combine(sums, settings_.combine), 1e-5,
                      &undecided));
  const reference::Map edges = map(BufferName::combined_edges);
  const auto lines =
      std::count_if(edges.samples.begin(), edges.samples.end(), [](double edge) { return edge > 0.0; });
  EXPECT_GT(static_cast<double>(lines) / edges.samples.size(), 0.02) << "the comparison saw lines";
  EXPECT_LT(static_cast<double>(lines) / edges.samples.size(), 0.5);
}

TEST_F(PaperScene, shading_equals_reference) {
  const reference::Shading expected = reference::shade(
      settings_, map(BufferName::normal), map(BufferName::depth), map(BufferName::object_id), true);
  EXPECT_TRUE(is_near(raw(BufferName::shaded), expected.colour, 5e-4, &expected.at_step));
  EXPECT_LT(share_of(expected.at_step), 0.05);
}

TEST_F(PaperScene, final_is_ink_over_the_shading) {
  EXPECT_TRUE(is_near(raw(BufferName::final),
                      reference::ink(map(BufferName::shaded), map(BufferName::combined_edges), settings_.ink),
                      0.0));
}

}  // namespace
}  // namespace inkbench
