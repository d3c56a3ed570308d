// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <utility>

#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {
namespace {

/// Both meshes as one, the second moved by `offset`.
Mesh beside(Mesh a, const Mesh& b, const glm::vec3& offset) {
  const auto base = static_cast<uint32_t>(a.positions.size());
  for (const glm::vec3& p : b.positions) a.positions.push_back(p + offset);
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return a;
}

TEST(ClosedMesh, solids_with_outward_faces_are_closed) {
  EXPECT_TRUE(is_closed_outwards(make_box(3)));
  EXPECT_TRUE(is_closed_outwards(make_rounded_box(4, 0.2F)));
  EXPECT_TRUE(is_closed_outwards(make_sphere(16)));
  EXPECT_TRUE(is_closed_outwards(make_torus(12, 0.3F)));
  EXPECT_TRUE(is_closed_outwards(load_mesh_file(find_rabbit())));
}

TEST(ClosedMesh, a_plane_and_an_inside_out_sphere_are_not) {
  EXPECT_FALSE(is_closed_outwards(make_plane(2)));
  EXPECT_FALSE(is_closed_outwards(make_inside_out_sphere(16)));
}

TEST(ClosedMesh, one_missing_or_turned_face_opens_it) {
  Mesh missing = make_sphere(8);
  missing.triangles.pop_back();
  EXPECT_FALSE(is_closed_outwards(missing));
  Mesh turned = make_sphere(8);
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  EXPECT_FALSE(is_closed_outwards(turned));
}

TEST(ClosedMesh, two_sheets_on_the_same_edges_are_not) {
  EXPECT_FALSE(is_closed_outwards(beside(make_sphere(8), make_sphere(8), {0, 0, 0})));
}

TEST(ClosedMesh, a_face_without_area_between_two_equal_points_opens_nothing) {
  Mesh sphere = make_sphere(8);
  const auto twin = static_cast<uint32_t>(sphere.positions.size());
  const auto [a, b, c] = sphere.triangles[5];
  sphere.positions.push_back(sphere.positions[a]);
  sphere.triangles.push_back({a, twin, b});
  EXPECT_TRUE(is_closed_outwards(sphere));
}

TEST(ClosedMesh, every_part_must_face_outwards) {
  EXPECT_TRUE(is_closed_outwards(beside(make_sphere(8), make_box(1), {5, 0, 0})));
  EXPECT_FALSE(is_closed_outwards(beside(make_sphere(16), make_inside_out_sphere(8), {0.1F, 0, 0})));
  EXPECT_FALSE(is_closed_outwards(beside(make_sphere(8), make_plane(1), {5, 0, 0})));
}

}  // namespace
}  // namespace inkbench
