// SPDX-License-Identifier: MIT
// Edges and their faces, and the classes of lines along them, before any view.
#include "pipeline/lines/topology.h"

#include <gtest/gtest.h>

#include "pipeline/lines/mesh_lines.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/reference_support.h"

namespace inkbench {
namespace {

size_t edges_with(const MeshTopology& topology, uint32_t faces) {
  return static_cast<size_t>(std::count_if(topology.edges.begin(), topology.edges.end(),
                                           [&](const auto& edge) { return edge.use_count == faces; }));
}

TEST(ReferenceTopology, box_is_welded_at_its_edges) {
  const MeshTopology box = make_topology(make_box(1));
  EXPECT_EQ(box.positions.size(), 8U);
  EXPECT_EQ(box.faces.size(), 12U);
  EXPECT_EQ(box.edges.size(), 18U);
  EXPECT_EQ(edges_with(box, 2), 18U);
  EXPECT_EQ(boundary_edges(box).size(), 0U);
  EXPECT_EQ(crease_edges(box).size(), 12U);
}

TEST(ReferenceTopology, closed_shapes_obey_euler) {
  const MeshTopology sphere = make_topology(make_sphere(16));
  EXPECT_EQ(sphere.positions.size() + sphere.faces.size(), sphere.edges.size() + 2);
  EXPECT_EQ(edges_with(sphere, 2), sphere.edges.size());
  const MeshTopology torus = make_topology(make_torus(16, 0.3F));
  EXPECT_EQ(torus.positions.size() + torus.faces.size(), torus.edges.size());
}

TEST(ReferenceTopology, face_edges_lead_from_corner_to_corner) {
  const MeshTopology topology = make_topology(make_torus(5, 0.3F));
  for (uint32_t f = 0; f < topology.faces.size(); ++f) {
    for (size_t i = 0; i < 3; ++i) {
      const MeshTopology::Edge& edge = topology.edges[topology.face_edges[f][i]];
      const std::array<uint32_t, 2> ends =
          std::minmax({topology.faces[f][i], topology.faces[f][(i + 1) % 3]}) ==
                  std::pair{edge.points[0], edge.points[1]}
              ? edge.points
              : std::array<uint32_t, 2>{~0U, ~0U};
      EXPECT_EQ(ends, edge.points);
      bool uses_face = false;
      for (const MeshTopology::Use& use : topology.uses_of(edge)) {
        uses_face |= use.face == f && use.forward == (topology.faces[f][i] == edge.points[0]);
      }
      EXPECT_TRUE(uses_face);
    }
  }
}

TEST(ReferenceTopology, plane_has_its_rim_as_boundary) {
  EXPECT_EQ(boundary_edges(make_topology(make_plane(7))).size(), 28U);
  EXPECT_TRUE(crease_edges(make_topology(make_plane(7))).empty());
}

TEST(ReferenceTopology, crease_needs_more_than_forty_degrees) {
  for (const double degrees : {39.9, 40.1}) {
    const double angle = degrees * 3.14159265358979 / 180.0;
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    const MeshTopology roof =
        make_topology(plain_mesh({{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {c, -s, 0}}, {{0, 2, 1}, {0, 1, 3}}));
    EXPECT_EQ(crease_edges(roof).size(), degrees > 40.0 ? 1U : 0U) << degrees;
  }
}

TEST(ReferenceTopology, crease_angle_is_that_of_the_stretched_mesh) {
  // A roof of 30 degrees; twice as high its faces differ by 2 atan(2 tan 15) = 56.4 degrees.
  const float h = std::tan(15.0F * 3.14159265F / 180.0F);
  const MeshTopology roof =
      make_topology(plain_mesh({{0, h, 0}, {0, h, 1}, {-1, 0, 0}, {1, 0, 0}}, {{0, 2, 1}, {0, 1, 3}}));
  glm::dmat3 stretch(1.0);
  EXPECT_TRUE(crease_edges(roof, 40.0, stretch).empty());
  stretch[1][1] = 2.0;
  EXPECT_EQ(crease_edges(roof, 40.0, stretch).size(), 1U);
  EXPECT_EQ(crease_edges(roof, 56.0, stretch).size(), 1U);
  EXPECT_TRUE(crease_edges(roof, 57.0, stretch).empty());
}

TEST(ReferenceTopology, repeated_and_collapsed_faces_are_left_out) {
  const MeshTopology topology = make_topology(plain_mesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {{0, 1, 2}, {1, 2, 0}, {3, 1, 2}, {0, 3, 1}, {0, 0, 1}}));
  EXPECT_EQ(topology.faces.size(), 1U);
  EXPECT_EQ(boundary_edges(topology).size(), 3U);
}

TEST(ReferenceTopology, negative_zero_is_zero) {
  const MeshTopology topology = make_topology(plain_mesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0F, 0, 0}, {1, -0.0F, 0}, {0, -1, 0}}, {{0, 1, 2}, {4, 3, 5}}));
  EXPECT_EQ(topology.positions.size(), 4U);
  EXPECT_EQ(edges_with(topology, 2), 1U);
}

/// A flat square whose diagonal is split by a face without area on one side.
Mesh square_with_flat_face() {
  return plain_mesh({{0, 0, 0}, {2, 0, 0}, {2, 0, -2}, {0, 0, -2}, {1, 0, -1}},
                    {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}});
}

TEST(ReferenceTopology, face_without_area_takes_the_normal_across_its_longest_edge) {
  const MeshTopology topology = make_topology(square_with_flat_face());
  for (const glm::dvec3& normal : topology.normals) EXPECT_EQ(normal, glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_EQ(boundary_edges(topology).size(), 4U);
  EXPECT_TRUE(crease_edges(topology).empty());
  for (const double height : {1.0, -1.0}) {
    EXPECT_TRUE(silhouette_edges(topology, face_facings(topology, {0.3, height, 5.0})).empty());
  }
}

TEST(ReferenceTopology, faces_without_area_alone_have_no_normal_and_no_silhouette) {
  const MeshTopology topology =
      make_topology(plain_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(topology.normals[0], glm::dvec3(0.0));
  EXPECT_TRUE(silhouette_edges(topology, face_facings(topology, {0, 1, 0})).empty());
  EXPECT_TRUE(crease_edges(topology).empty());
}

TEST(ReferenceTopology, face_seen_exactly_edge_on_counts_as_back_facing) {
  // The eye lies in the plane of the box's top: the top's front edge is the silhouette, the far one is not.
  const MeshTopology box = make_topology(make_box(1));
  const std::vector<int8_t> facings = face_facings(box, {0.0, 0.5, 3.0});
  std::vector<uint32_t> silhouettes = silhouette_edges(box, facings);
  EXPECT_EQ(silhouettes.size(), 4U);
  for (const uint32_t edge : silhouettes) {
    for (const uint32_t point : box.edges[edge].points) EXPECT_EQ(box.positions[point].z, 0.5);
  }
}

TEST(ReferenceTopology, mirrored_mesh_is_turned_inside_out) {
  const MeshTopology box = make_topology(make_box(1));
  const std::vector<int8_t> plain = face_facings(box, {1.0, 2.0, 3.0});
  const std::vector<int8_t> mirrored = face_facings(box, {1.0, 2.0, 3.0}, true);
  for (size_t f = 0; f < plain.size(); ++f) EXPECT_EQ(plain[f], -mirrored[f]);
}

TEST(ReferenceTopology, sheet_with_two_sides_has_lines_along_its_rim_only) {
  Mesh sheet = make_plane(4);
  const size_t faces = sheet.triangles.size();
  for (size_t f = 0; f < faces; ++f)
    sheet.triangles.push_back({sheet.triangles[f][0], sheet.triangles[f][2], sheet.triangles[f][1]});
  const MeshTopology topology = make_topology(sheet);
  EXPECT_EQ(edges_with(topology, 4), topology.edges.size() - 16);
  EXPECT_EQ(silhouette_edges(topology, face_facings(topology, {0.0, 2.0, 1.0})).size(), 16U);
  EXPECT_EQ(crease_edges(topology).size(), 16U);
  EXPECT_TRUE(boundary_edges(topology).empty());
}

/// Two boxes of which an edge of one is an edge of the other: four faces meet there.
Mesh touching_boxes() {
  Mesh boxes = make_box(1);
  const Mesh other = make_box(1);
  const auto first = static_cast<uint32_t>(boxes.positions.size());
  for (const glm::vec3& position : other.positions) boxes.positions.push_back(position + glm::vec3(1, 1, 0));
  boxes.normals.insert(boxes.normals.end(), other.normals.begin(), other.normals.end());
  for (const auto& t : other.triangles) boxes.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return boxes;
}

TEST(ReferenceTopology, edge_where_two_solids_touch_is_a_silhouette_only_if_seen_as_one) {
  const MeshTopology boxes = make_topology(touching_boxes());
  ASSERT_EQ(edges_with(boxes, 4), 1U);
  const auto shared = static_cast<uint32_t>(
      std::find_if(boxes.edges.begin(), boxes.edges.end(), [](const auto& e) { return e.use_count == 4; }) -
      boxes.edges.begin());
  const auto is_silhouette = [&](const glm::dvec3& eye) {
    const std::vector<uint32_t> found = silhouette_edges(boxes, face_facings(boxes, eye));
    return std::find(found.begin(), found.end(), shared) != found.end();
  };
  // From the quadrant of air between them both front faces meet in a valley; from in front of a box the edge
  // is where its front ends and the other's goes on behind.
  EXPECT_FALSE(is_silhouette({5.0, -5.0, 0.0}));
  EXPECT_FALSE(is_silhouette({-5.0, 5.0, 0.0}));
  const std::vector<uint32_t> creases = crease_edges(boxes);
  EXPECT_EQ(creases.size(), 23U);
  EXPECT_NE(std::find(creases.begin(), creases.end(), shared), creases.end());
}

TEST(ReferenceTopology, fin_on_a_sheet_is_a_crease) {
  // A flat sheet of two triangles and a third upright on their common edge.
  const MeshTopology fin = make_topology(plain_mesh({{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                                    {{0, 2, 1}, {0, 1, 3}, {0, 1, 4}}));
  EXPECT_EQ(edges_with(fin, 3), 1U);
  EXPECT_EQ(crease_edges(fin).size(), 1U);
  EXPECT_EQ(boundary_edges(fin).size(), 6U);
}

TEST(ReferenceTopology, empty_mesh_has_nothing) {
  const MeshTopology empty = make_topology(Mesh{});
  EXPECT_TRUE(empty.edges.empty());
  EXPECT_TRUE(boundary_edges(empty).empty());
  EXPECT_TRUE(make_features(empty).creases.empty());
}

}  // namespace
}  // namespace inkbench
