// SPDX-License-Identifier: MIT
// Where faces of unequal edges meet, the surface goes on: no line is wanted there.
#include "pipeline/lines/covered_borders.h"

#include <gtest/gtest.h>

#include "pipeline/lines/mesh_lines.h"

namespace inkbench {
namespace {

/// A square of side 2 beside two of half its width above each other, the right ones turned up by `rise`.
Mesh t_junction(float rise, float gap = 0.0F) {
  Mesh mesh;
  mesh.positions = {{-2, 0, 0}, {0, 0, 0}, {0, 2, 0}, {-2, 2, 0}};
  for (const float y : {0.0F, 1.0F, 2.0F}) {
    mesh.positions.emplace_back(gap, y, 0);
    mesh.positions.emplace_back(1, y, rise);
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6}, {6, 7, 9}, {6, 9, 8}};
  return mesh;
}

size_t borders(const Mesh& mesh, double angle_deg = kCreaseAngleDeg) {
  return boundary_edges(make_topology(mesh), angle_deg).size();
}

TEST(CoveredBorders, a_t_junction_in_a_plane_leaves_the_outline_alone) {
  EXPECT_EQ(borders(t_junction(0)), 7U);
}

TEST(CoveredBorders, faces_that_bend_more_than_the_crease_angle_keep_their_border) {
  EXPECT_EQ(borders(t_junction(1.0F), 44.0), 10U) << "45 degrees";
  EXPECT_EQ(borders(t_junction(1.0F), 46.0), 7U);
}

TEST(CoveredBorders, a_gap_of_more_than_a_millionth_is_a_gap) {
  EXPECT_EQ(borders(t_junction(0, 1e-6F)), 7U);
  EXPECT_EQ(borders(t_junction(0, 1e-4F)), 10U);
}

TEST(CoveredBorders, a_border_that_is_covered_in_part_stays) {
  Mesh mesh = t_junction(0);
  mesh.triangles.resize(4);  // without the upper of the two
  EXPECT_EQ(borders(mesh), 7U);
}

}  // namespace
}  // namespace inkbench
