// SPDX-License-Identifier: MIT
// Welding within a tolerance, and cutting into manifold pieces.
#include "pipeline/mesh/weld.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "pipeline/mesh/weld_manifold.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
constexpr uint32_t kLeftOut = ManifoldPieces::kLeftOut;

/// Every triangle with corners of its own, as an STL has them, moved by up to `jitter` in each coordinate.
Mesh jittered_soup_of(const Mesh& mesh, float jitter) {
  Mesh soup;
  uint32_t random = 1;
  for (const auto& t : mesh.triangles) {
    for (const uint32_t vertex : t) {
      glm::vec3 offset;
      for (int axis = 0; axis < 3; ++axis) {
        random = random * 1664525U + 1013904223U;
        offset[axis] = jitter * (static_cast<float>(random >> 8) / 8388608.0F - 1.0F);
      }
      soup.positions.push_back(mesh.positions[vertex] + offset);
      soup.normals.push_back(mesh.normals[vertex]);
    }
    const auto base = static_cast<uint32_t>(soup.positions.size());
    soup.triangles.push_back({base - 3, base - 2, base - 1});
  }
  return soup;
}

Mesh mesh_of(std::vector<glm::vec3> positions, std::vector<std::array<uint32_t, 3>> triangles) {
  Mesh mesh;
  mesh.normals.assign(positions.size(), glm::vec3(0, 0, 1));
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  return mesh;
}

TEST(Weld, equal_positions_become_one_vertex) {
  const Mesh torus = make_torus(12, 0.3F);
  const WeldResult result = weld(jittered_soup_of(torus, 0.0F), 0.0F);
  EXPECT_EQ(result.mesh.positions.size(), torus.positions.size());
  EXPECT_EQ(result.merged_vertices, 3 * torus.triangles.size() - torus.positions.size());
  EXPECT_EQ(result.mesh.triangles.size(), torus.triangles.size());
  ASSERT_EQ(result.mesh.notes.size(), 1U);
  EXPECT_THAT(result.mesh.notes[0], HasSubstr("Merged"));
}

TEST(Weld, a_tolerance_closes_what_rounding_opened) {
  const Mesh torus = make_torus(12, 0.3F);
  const Mesh soup = jittered_soup_of(torus, 1e-4F);
  EXPECT_FALSE(is_closed_outwards(weld(soup, 0.0F).mesh));
  const WeldResult result = weld(soup, 4e-4F);
  EXPECT_EQ(result.mesh.positions.size(), torus.positions.size());
  EXPECT_TRUE(is_closed_outwards(result.mesh));
}

TEST(Weld, neighbours_across_cells_and_signs_meet) {
  const Mesh mesh =
      mesh_of({{-1e-3F, 0, 0}, {1e-3F, 0, 0}, {5, 0, 0}, {5, 1, 0}, {0.0F, 7, 0}, {-0.0F, 7, 0}},
              {{0, 2, 3}, {1, 3, 2}});
  EXPECT_EQ(weld(mesh, 2.5e-3F).merged_vertices, 2U);
  EXPECT_EQ(weld(mesh, 1.5e-3F).merged_vertices, 1U) << "zero is zero, whatever its sign";
  EXPECT_EQ(weld(mesh, 0.0F).merged_vertices, 1U);
}

TEST(Weld, merging_does_not_creep_along_a_chain) {
  std::vector<glm::vec3> row;
  for (int i = 0; i < 10; ++i) row.emplace_back(0.75F * static_cast<float>(i), 0, 0);
  EXPECT_EQ(weld(mesh_of(row, {}), 1.0F).mesh.positions.size(), 5U);
}

TEST(Weld, triangles_that_lose_a_side_are_dropped_and_counted) {
  const Mesh mesh = mesh_of({{0, 0, 0}, {0.01F, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 3, 2}});
  const WeldResult result = weld(mesh, 0.1F);
  EXPECT_EQ(result.dropped_triangles, 1U);
  EXPECT_EQ(result.mesh.triangles.size(), 1U);
  EXPECT_THAT(result.mesh.notes.back(), HasSubstr("1 triangle without area"));
}

TEST(Weld, merged_normals_are_the_mean) {
  const WeldResult result = weld(make_box(1), 0.0F);
  ASSERT_EQ(result.mesh.positions.size(), 8U);
  for (size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(glm::dot(result.mesh.normals[i], glm::normalize(result.mesh.positions[i])), 1.0F, 1e-5F);
}

TEST(Weld, a_mesh_without_repetitions_stays_as_it_is) {
  const Mesh torus = make_torus(12, 0.3F);
  const WeldResult result = weld(torus, 0.0F);
  EXPECT_EQ(result.mesh.positions, torus.positions);
  EXPECT_EQ(result.mesh.triangles, torus.triangles);
  EXPECT_TRUE(result.mesh.notes.empty());
}

TEST(Weld, a_bad_tolerance_is_an_error) {
  EXPECT_THAT(error_of([] { weld(make_box(1), -1.0F); }), HasSubstr("bad tolerance -1"));
  EXPECT_THAT(error_of([] { weld(make_box(1), std::numeric_limits<float>::quiet_NaN()); }),
              HasSubstr("bad tolerance"));
}

TEST(CutToManifold, a_box_is_one_piece_of_eight_points_per_segment) {
  const ManifoldPieces pieces = cut_to_manifold(make_box(1));
  EXPECT_EQ(pieces.origin.size(), 8U);
  EXPECT_EQ(pieces.triangles, 12U);
  EXPECT_TRUE(std::ranges::none_of(pieces.is_cut, [](bool cut) { return cut; }));
}

TEST(CutToManifold, an_edge_of_three_triangles_is_cut) {
  const ManifoldPieces pieces = cut_to_manifold(
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(pieces.triangles, 3U);
  EXPECT_EQ(pieces.origin.size(), 9U) << "each triangle for itself";
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(pieces.is_cut[pieces.corners[0][i]]);
  EXPECT_FALSE(pieces.is_cut[pieces.corners[0][2]]);
}

TEST(CutToManifold, surfaces_that_touch_in_a_point_are_cut_there) {
  const ManifoldPieces pieces = cut_to_manifold(
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}));
  EXPECT_EQ(pieces.origin.size(), 6U);
  EXPECT_NE(pieces.corners[0][0], pieces.corners[1][0]);
}

TEST(CutToManifold, neighbours_of_opposite_orientation_are_cut) {
  const ManifoldPieces pieces =
      cut_to_manifold(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(pieces.origin.size(), 6U);
}

TEST(CutToManifold, repetitions_are_left_out_and_back_sides_stand_alone) {
  const ManifoldPieces pieces =
      cut_to_manifold(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                              {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {0, 0, 1}, {2, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(pieces.triangles, 4U);
  EXPECT_EQ(pieces.corners[1][0], kLeftOut);
  EXPECT_EQ(pieces.corners[3][0], kLeftOut);
  EXPECT_EQ(pieces.origin.size(), 8U) << "a front of four points and a back of four";
  EXPECT_TRUE(std::ranges::none_of(pieces.is_cut, [](bool cut) { return cut; }));
}

TEST(CutToManifold, each_directed_edge_of_a_random_soup_belongs_to_one_triangle) {
  uint32_t random = 7;
  const auto draw = [&](uint32_t below) {
    random = random * 1664525U + 1013904223U;
    return (random >> 8) % below;
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 8; ++i) positions.emplace_back(i % 2, i / 2 % 2, i / 4);
    std::vector<std::array<uint32_t, 3>> triangles;
    for (int i = 0; i < 20; ++i) triangles.push_back({draw(8), draw(8), draw(8)});
    const ManifoldPieces pieces = cut_to_manifold(mesh_of(positions, triangles));
    std::set<std::pair<uint32_t, uint32_t>> edges;
    for (const auto& t : pieces.corners) {
      if (t[0] == kLeftOut) continue;
      for (int i = 0; i < 3; ++i) EXPECT_TRUE(edges.emplace(t[i], t[(i + 1) % 3]).second);
    }
  }
}

}  // namespace
}  // namespace inkbench
