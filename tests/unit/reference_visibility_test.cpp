// SPDX-License-Identifier: MIT
// Projection, clipping and the depth test, by hand-made buffers.
#include "pipeline/lines/visibility.h"

#include <gtest/gtest.h>

#include "tests/unit/reference_support.h"

namespace inkbench {
namespace {

// Default camera: eye (0, 0, 5), fov 45, near 0.1, far 20. At z = 5 a square image shows 2 * 5 tan(22.5).
const double kHalfView = 5.0 * std::tan(22.5 * 3.14159265358979 / 180.0);

TEST(ReferenceProjection, x_is_right_and_y_is_down) {
  const Projection projection(CameraParams{}, 200, 200, glm::mat4(1.0F));
  const std::vector<glm::dvec3> line{{0, 0, 0}, {kHalfView / 2, kHalfView / 4, 0}};
  const std::vector<ProjectedLine> lines = projection.project(line);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0][0].x, 100.0, 1e-4);
  EXPECT_NEAR(lines[0][0].y, 100.0, 1e-4);
  EXPECT_NEAR(lines[0][1].x, 150.0, 1e-4);
  EXPECT_NEAR(lines[0][1].y, 75.0, 1e-4);
  EXPECT_NEAR(lines[0][1].z, 0.2, 1e-7);
}

TEST(ReferenceProjection, line_through_the_eye_plane_is_cut_at_the_near_plane) {
  const Projection projection(CameraParams{}, 200, 200, glm::mat4(1.0F));
  const std::vector<glm::dvec3> line{{0.01, 0, 0}, {0.01, 0, 9}};  // ends 4 behind the eye
  const std::vector<ProjectedLine> lines = projection.project(line);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(1.0 / lines[0].back().z, 0.1, 1e-5);
  EXPECT_GT(lines[0].back().x, 100.0);
}

TEST(ReferenceProjection, orthographic_lines_keep_size_and_distance) {
  CameraParams camera{.eye = {3, 0, 4}, .far = 1000};
  camera.projection = CameraProjection::orthographic;
  camera.view_height = 4;
  const Projection projection(camera, 200, 100, glm::mat4(1.0F));
  // Forward (-0.6, 0, -0.8), right (0.8, 0, -0.6); 25 px each unit.
  const std::vector<glm::dvec3> line{{0, 1, 0}, {0.8 - 1.2, -1, -0.6 - 1.6}};
  const std::vector<ProjectedLine> lines = projection.project(line);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(glm::length(lines[0][0] - glm::dvec3(100, 25, 5)), 0.0, 1e-4);
  EXPECT_NEAR(glm::length(lines[0][1] - glm::dvec3(125, 75, 7)), 0.0, 1e-4);
}

TEST(ReferenceProjection, lines_outside_are_dropped) {
  const Projection projection(CameraParams{}, 200, 200, glm::mat4(1.0F));
  const auto count = [&](const std::vector<glm::dvec3>& line) { return projection.project(line).size(); };
  EXPECT_EQ(count({{-9, 9, 0}, {9, 9, 0}}), 0U);
  EXPECT_EQ(count({{-9, 0, 6}, {9, 0, 6}}), 0U);     // behind the eye
  EXPECT_EQ(count({{0, 0, -16}, {1, 0, -17}}), 0U);  // beyond far
  EXPECT_EQ(count({{0, -9, 0}, {9, 0, 0}}), 0U);     // past a corner
}

TEST(ReferenceProjection, line_is_cut_at_the_image_border) {
  const Projection projection(CameraParams{}, 200, 100, glm::mat4(1.0F));
  const std::vector<glm::dvec3> line{{0, 0, 0}, {0, 9, 0}, {0.5, 9, 0}, {0.5, -9, 0}};
  const std::vector<ProjectedLine> lines = projection.project(line);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(lines[0].back().y, 0.0, 1e-9);
  EXPECT_NEAR(lines[1].front().y, 0.0, 1e-9);
  EXPECT_NEAR(lines[1].back().y, 100.0, 1e-9);
}

TEST(ReferenceProjection, closed_line_that_is_cut_starts_at_a_cut) {
  const Projection projection(CameraParams{}, 200, 200, glm::mat4(1.0F));
  const std::vector<glm::dvec3> ring{{0, 0, 0}, {1, 0, 0}, {1, 9, 0}, {0, 9, 0}, {0, 0, 0}};
  const std::vector<ProjectedLine> lines = projection.project(ring);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].front().y, 0.0, 1e-9);
  EXPECT_NEAR(lines[0].back().y, 0.0, 1e-9);
  EXPECT_EQ(lines[0].size(), 4U);
}

TEST(ReferenceVisibility, samples_are_half_a_pixel_apart_and_keep_the_end) {
  const std::vector<LineSample> samples = sample_line({{0, 0, 1}, {1.3, 0, 1}, {1.3, 0.9, 1}});
  ASSERT_EQ(samples.size(), 6U);  // 0, 0.5, 1, 1.5, 2 and 2.2
  EXPECT_NEAR(samples[3].point.y, 0.2, 1e-12);
  EXPECT_NEAR(samples[4].along_px, 2.0, 1e-12);
  EXPECT_NEAR(samples[5].point.y, 0.9, 1e-12);
}

TEST(ReferenceVisibility, inverse_depth_is_linear_in_the_image) {
  // From z = 2 to z = 6: halfway in the image w is 1/3, z is 3 and not 4.
  const std::vector<LineSample> samples = sample_line({{0, 0, 0.5}, {10, 0, 1.0 / 6.0}});
  EXPECT_NEAR(1.0 / samples[10].point.z, 3.0, 1e-12);
}

TEST(ReferenceVisibility, slack_is_one_thousandth_of_inverse_depth) {
  Image depth(9, 9, 1, 0.5F);  // far 20: z = 10
  const DepthTest test(depth, CameraParams{});
  EXPECT_TRUE(test.is_visible({4.5, 4.5, 0.1 * 0.9991}));
  EXPECT_FALSE(test.is_visible({4.5, 4.5, 0.1 * 0.9989}));
  EXPECT_TRUE(test.is_visible({4.5, 4.5, 1.0}));
}

TEST(ReferenceVisibility, slack_is_one_thousandth_of_the_height_of_an_orthographic_view) {
  Image depth(9, 9, 1, 0.5F);
  CameraParams camera;  // far 20: z = 10
  camera.projection = CameraProjection::orthographic;
  for (const double height : {0.5, 40.0}) {
    camera.view_height = static_cast<float>(height);
    const DepthTest test(depth, camera);
    EXPECT_TRUE(test.is_visible({4.5, 4.5, 10.0 + 0.00099 * height}));
    EXPECT_FALSE(test.is_visible({4.5, 4.5, 10.0 + 0.00101 * height}));
    EXPECT_TRUE(test.is_visible({4.5, 4.5, 0.1}));
  }
}

TEST(ReferenceVisibility, farthest_of_nine_pixels_decides) {
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      Image depth(9, 9, 1, 0.25F);
      depth.at(4 + dx, 4 + dy) = 0.5F;
      const bool beside = std::abs(dx) <= 1 && std::abs(dy) <= 1;
      EXPECT_EQ(DepthTest(depth, CameraParams{}).is_visible({4.01, 4.99, 0.1}), beside) << dx << ", " << dy;
    }
  }
}

TEST(ReferenceVisibility, image_corners_are_tested_with_what_there_is) {
  Image depth(4, 4, 1, 0.25F);
  const DepthTest test(depth, CameraParams{});
  for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(4, 4), glm::dvec2(4, 0)}) {
    EXPECT_FALSE(test.is_visible({corner, 0.19}));
    EXPECT_TRUE(test.is_visible({corner, 0.2}));
  }
}

/// A line along y = 10 in front of (z = 4) and behind (z = 10) a wall at z = 5 that covers some columns.
Image wall(int from, int to) {
  Image depth(100, 20, 1, 1.0F);
  for (int y = 0; y < 20; ++y) {
    for (int x = from; x < to; ++x) depth.at(x, y) = 0.25F;
  }
  return depth;
}

TEST(ReferenceVisibility, hidden_middle_splits_a_line) {
  const Image depth = wall(40, 60);
  const std::vector<ProjectedLine> pieces =
      visible_pieces({{10, 10, 0.1}, {90, 10, 0.1}}, DepthTest(depth, CameraParams{}));
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].front().x, 10.0);
  EXPECT_NEAR(pieces[0].back().x, 40.5, 0.51);  // one pixel into the wall's border
  EXPECT_NEAR(pieces[1].front().x, 59.5, 0.51);
  EXPECT_EQ(pieces[1].back().x, 90.0);
  EXPECT_EQ(visible_pieces({{10, 10, 0.25}, {90, 10, 0.25}}, DepthTest(depth, CameraParams{})).size(), 1U);
}

TEST(ReferenceVisibility, pieces_under_three_pixels_are_dropped) {
  const Image depth(20, 20, 1, 1.0F);
  const DepthTest test(depth, CameraParams{});
  EXPECT_TRUE(visible_pieces({{5, 5, 0.1}, {7.99, 5, 0.1}}, test).empty());
  EXPECT_EQ(visible_pieces({{5, 5, 0.1}, {8, 5, 0.1}}, test).size(), 1U);
}

TEST(ReferenceVisibility, closed_line_stays_closed_or_runs_across_its_start) {
  const ProjectedLine ring{{20, 5, 0.1}, {80, 5, 0.1}, {80, 15, 0.1}, {20, 15, 0.1}, {20, 5, 0.1}};
  const Image open(100, 20, 1, 1.0F);
  const std::vector<ProjectedLine> whole = visible_pieces(ring, DepthTest(open, CameraParams{}));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0], ring);
  const Image half = wall(50, 100);
  const std::vector<ProjectedLine> cut = visible_pieces(ring, DepthTest(half, CameraParams{}));
  ASSERT_EQ(cut.size(), 1U);
  EXPECT_EQ(cut[0].size(), 4U);
  EXPECT_NEAR(cut[0].front().y, 15.0, 1e-9);
  EXPECT_NEAR(cut[0].back().y, 5.0, 1e-9);
}

}  // namespace
}  // namespace inkbench
