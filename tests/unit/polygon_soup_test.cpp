// SPDX-License-Identifier: MIT
// From raw polygons to the drawable mesh, its normals and bounds, and the way through the pipe.
#include "pipeline/mesh/mesh_from_soup.h"
#include "pipeline/mesh/normals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "pipeline/base/error.h"
#include "pipeline/mesh/formats/mesh_file.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const float kNotANumber = std::numeric_limits<float>::quiet_NaN();

double total_area(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 origin = mesh.positions[a];
    sum += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[b]) - origin,
                                        glm::dvec3(mesh.positions[c]) - origin));
  }
  return sum;
}

PolygonSoup one_triangle() {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.corner_counts = {3};
  soup.corners = {0, 1, 2};
  return soup;
}

TEST(PolygonSoupToMesh, clean_soup_with_normals_needs_no_note) {
  PolygonSoup soup = one_triangle();
  soup.normals = {{0, 0, 5}, {0, 0, 1e-30F}, {0, 0, 3e38F}};
  soup.corner_normals = {0, 1, 2};
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_THAT(mesh.notes, ::testing::IsEmpty());
  EXPECT_THAT(mesh.normals, ::testing::Each(glm::vec3(0, 0, 1)));
}

TEST(PolygonSoupToMesh, a_concave_quad_keeps_its_area_whatever_its_first_corner) {
  for (int start = 0; start < 4; ++start) {
    PolygonSoup soup;
    soup.points = {{0, 0, 0}, {2, -1, 0}, {0, 3, 0}, {-2, -1, 0}};
    soup.corner_counts = {4};
    for (int i = 0; i < 4; ++i) soup.corners.push_back((start + i) % 4);
    EXPECT_NEAR(total_area(mesh_from_soup(soup, "x")), 6.0, 1e-12) << start;
  }
}

TEST(PolygonSoupToMesh, a_corner_in_the_middle_of_a_side_stays_connected) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  soup.corner_counts = {5};
  soup.corners = {0, 1, 2, 3, 4};
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_EQ(mesh.triangles.size(), 3U);
  EXPECT_EQ(mesh.positions.size(), 5U);
  EXPECT_NEAR(total_area(mesh), 4.0, 1e-12);
}

TEST(PolygonSoupToMesh, polygons_of_any_corner_count_and_index_are_survived) {
  PolygonSoup soup = one_triangle();
  soup.corner_counts = {3, 0, 1, 2, 4, 3};
  soup.corners = {0, 1, 2, 0, 1, 2, 0, 1, 2, -7, 0, 1, std::numeric_limits<int32_t>::min()};
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.notes[0],
            "Dropped 2 faces naming a vertex outside the file's 3 (such as index -2,147,483,648, counted "
            "from 0).");
  EXPECT_EQ(mesh.notes[1], "Dropped 3 faces without area.");
}

TEST(PolygonSoupToMesh, tiny_and_huge_triangles_have_area_and_unit_normals) {
  for (const float scale : {1e-44F, 1e-20F, 1e18F, 3e38F}) {
    PolygonSoup soup = one_triangle();
    for (glm::dvec3& point : soup.points) point *= scale;
    const Mesh mesh = mesh_from_soup(soup, "x");
    EXPECT_THAT(mesh.normals, ::testing::Each(glm::vec3(0, 0, 1))) << scale;
  }
}

TEST(PolygonSoupToMesh, an_unused_bad_normal_does_not_spoil_the_others) {
  PolygonSoup soup = one_triangle();
  soup.points.emplace_back(kNotANumber);
  soup.normals = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {kNotANumber, 0, 0}};
  soup.corner_normals = {0, 1, 2};
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_THAT(mesh.normals, ::testing::Each(glm::vec3(0, 1, 0)));
  EXPECT_THAT(mesh.notes, ElementsAre("Removed 1 isolated vertex that no drawn face uses."));
}

TEST(PolygonSoupToMesh, a_soup_without_a_drawable_face_is_an_input_error) {
  PolygonSoup soup = one_triangle();
  soup.points[1] = {0, 2, 0};
  try {
    mesh_from_soup(soup, "flat.obj");
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), HasSubstr("flat.obj: no face can be drawn: Dropped 1 face without area."));
  }
}

TEST(SmoothNormals, weigh_faces_by_their_angle_not_by_their_count) {
  // A cube's corner, one of its three sides cut into two triangles there: the normal stays on the diagonal.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  mesh.triangles = {{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {0, 3, 2}};
  smooth_normals(mesh);
  EXPECT_NEAR(glm::length(mesh.normals[0] + glm::normalize(glm::vec3(1))), 0.0F, 1e-6F);
}

TEST(SmoothNormals, vertices_without_a_usable_face_point_up) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {5, 5, 5}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {3, 3, 3}};
  mesh.normals = {glm::vec3(kNotANumber)};
  smooth_normals(mesh);
  EXPECT_THAT(mesh.normals,
              ElementsAre(glm::vec3(0, 1, 0), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0)));
}

TEST(BoundsOf, covers_used_points_only) {
  Mesh mesh;
  EXPECT_EQ(bounds_of(mesh).high, glm::vec3(0));
  mesh.positions = {{100, 0, 0}, {1, -2, 3}, {4, 5, -6}, {1, 1, 1}};
  mesh.triangles = {{1, 2, 3}};
  EXPECT_EQ(bounds_of(mesh).low, glm::vec3(1, -2, -6));
  EXPECT_EQ(bounds_of(mesh).high, glm::vec3(4, 5, 3));
}

}  // namespace
}  // namespace inkbench
