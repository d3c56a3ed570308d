// SPDX-License-Identifier: MIT
// Loop's subdivision: its weights, its counts, and the meshes that OpenMesh alone would get wrong.
#include "pipeline/mesh/levels/subdivide.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

TEST(Subdivide, no_round_is_the_mesh_itself) {
  const Mesh box = make_box(2);
  const Mesh same = subdivide_mesh(box, 0);
  EXPECT_EQ(same.positions, box.positions);
  EXPECT_EQ(same.normals, box.normals);
  EXPECT_EQ(same.triangles, box.triangles);
}

TEST(Subdivide, each_round_makes_four_faces_of_one) {
  const Mesh torus = make_torus(6, 0.3F);
  for (int rounds = 1; rounds <= kMaxSubdivisionRounds; ++rounds) {
    const Mesh fine = subdivide_mesh(torus, rounds);
    EXPECT_EQ(fine.triangles.size(), torus.triangles.size() << (2 * rounds));
    EXPECT_EQ(fine.positions.size(), torus.positions.size() << (2 * rounds)) << "a torus has V = F / 2";
    EXPECT_TRUE(is_closed_outwards(fine));
  }
}

TEST(Subdivide, an_octahedrons_points_move_by_loops_weights) {
  const Mesh octahedron = make_sphere(2);
  ASSERT_EQ(octahedron.triangles.size(), 8U);
  const Mesh fine = subdivide_mesh(octahedron, 1);
  // alpha(4) = (40 - 3^2) / 64; the neighbours' mean is the origin. A new point is 3/8 (a + b) + 1/8 (c + d),
  // c = -d.
  const double corner = 1.0 - 31.0 / 64.0;
  const double middle = 0.375 * std::sqrt(2.0);
  int corners = 0;
  for (const glm::vec3& p : fine.positions) {
    const double length = glm::length(glm::dvec3(p));
    const bool is_corner = std::abs(length - corner) < 1e-6;
    corners += is_corner ? 1 : 0;
    EXPECT_TRUE(is_corner || std::abs(length - middle) < 1e-6) << length;
  }
  EXPECT_EQ(corners, 6);
}

TEST(Subdivide, double_vertices_open_no_cracks) {
  EXPECT_TRUE(is_closed_outwards(subdivide_mesh(make_box(1), 2)));
}

TEST(Subdivide, a_pole_of_more_than_fifty_edges_stays_in_place) {
  const Mesh sphere = make_sphere(40);
  const Mesh fine = subdivide_mesh(sphere, 1);
  float highest = 0.0F;
  for (const glm::vec3& p : fine.positions) {
    EXPECT_LT(glm::length(p), 1.0001F);
    EXPECT_GT(glm::length(p), 0.98F);
    highest = std::max(highest, p.y);
  }
  EXPECT_GT(highest, 0.99F);
}

TEST(Subdivide, a_plane_stays_flat_and_keeps_the_middles_of_its_sides) {
  const Mesh fine = subdivide_mesh(make_plane(4), 2);
  glm::vec3 low(1.0F);
  glm::vec3 high(-1.0F);
  for (size_t i = 0; i < fine.positions.size(); ++i) {
    EXPECT_NEAR(fine.positions[i].y, 0.0F, 1e-7F);
    EXPECT_NEAR(fine.normals[i].y, 1.0F, 1e-5F);
    low = glm::min(low, fine.positions[i]);
    high = glm::max(high, fine.positions[i]);
  }
  EXPECT_NEAR(low.x, -0.5F, 1e-5F);
  EXPECT_NEAR(high.z, 0.5F, 1e-5F);
}

TEST(Subdivide, rounds_out_of_range_are_an_error) {
  EXPECT_THAT(error_of([] { subdivide_mesh(make_box(1), 5); }), HasSubstr("0 to 4"));
  EXPECT_THAT(error_of([] { subdivide_mesh(make_box(1), -1); }), HasSubstr("0 to 4"));
}

TEST(Subdivide, too_many_faces_are_an_error_before_any_work) {
  const std::string message = error_of([] { subdivide_mesh(make_plane(256), 4); });
  EXPECT_THAT(message, HasSubstr("4 rounds make 33,554,432 faces of 131,072"));
  EXPECT_THAT(message, HasSubstr("at most 20,000,000"));
}

}  // namespace
}  // namespace inkbench
