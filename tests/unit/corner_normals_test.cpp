// SPDX-License-Identifier: MIT
// Normals corner by corner: what a file says, where edges are smooth and where they are sharp, which side of
// a surface is its front.
#include "pipeline/mesh/corner_normals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "pipeline/mesh/mesh_from_soup.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

void add_polygon(PolygonSoup& soup, const std::vector<int32_t>& corners) {
  soup.corner_counts.push_back(static_cast<uint32_t>(corners.size()));
  soup.corners.insert(soup.corners.end(), corners.begin(), corners.end());
}

/// A cube of side 2 around the origin, outwards.
PolygonSoup cube_soup() {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.emplace_back((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1);
  for (const auto& face :
       {std::vector{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    add_polygon(soup, {face.begin(), face.end()});
  return soup;
}

PolygonSoup soup_of(const Mesh& mesh) {
  PolygonSoup soup;
  soup.points.assign(mesh.positions.begin(), mesh.positions.end());
  for (const auto& t : mesh.triangles)
    add_polygon(soup, {static_cast<int32_t>(t[0]), static_cast<int32_t>(t[1]), static_cast<int32_t>(t[2])});
  return soup;
}

size_t point_count(const Mesh& mesh) {
  const std::vector<uint32_t> first = first_at_same_position(mesh.positions);
  return std::set(first.begin(), first.end()).size();
}

/// The largest angle in degrees between a corner's normal and its face's.
double largest_tilt(const Mesh& mesh) {
  double least = 1.0;
  for (const auto& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (const uint32_t vertex : t) least = std::min<double>(least, glm::dot(normal, mesh.normals[vertex]));
  }
  return std::acos(std::clamp(least, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

TEST(CornerNormals, a_cube_without_normals_has_sharp_edges_and_a_sphere_smooth_ones) {
  const Mesh cube = mesh_from_soup(cube_soup(), "x");
  EXPECT_EQ(cube.positions.size(), 24U);
  EXPECT_LT(largest_tilt(cube), 0.01);
  const Mesh sphere = mesh_from_soup(soup_of(make_sphere(24)), "x");
  EXPECT_EQ(sphere.positions.size(), point_count(sphere));
  for (size_t i = 0; i < sphere.positions.size(); ++i)
    EXPECT_GT(glm::dot(sphere.normals[i], glm::normalize(sphere.positions[i])), 0.99F);
}

TEST(CornerNormals, smooth_and_flat_smooth_all_edges_and_none) {
  EXPECT_EQ(mesh_from_soup(cube_soup(), "x", {.smooth_below_deg = 180.0}).positions.size(), 8U);
  const Mesh flat = mesh_from_soup(soup_of(make_sphere(12)), "x", {.smooth_below_deg = 0.0});
  EXPECT_LT(largest_tilt(flat), 0.1);
}

TEST(CornerNormals, each_corner_keeps_the_normal_that_the_file_gives_it) {
  PolygonSoup soup = cube_soup();
  soup.normals = {{0, 0, -2}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
  for (int face = 0; face < 6; ++face) soup.corner_normals.insert(soup.corner_normals.end(), 4, face);
  const Mesh mesh = mesh_from_soup(soup, "x", {.smooth_below_deg = 180.0});
  EXPECT_EQ(mesh.positions.size(), 24U);
  EXPECT_LT(largest_tilt(mesh), 0.01);
  EXPECT_TRUE(mesh.has_given_normals);
  EXPECT_THAT(mesh.notes, IsEmpty());
  EXPECT_EQ(
      mesh_from_soup(soup, "x", {.use_file_normals = false, .smooth_below_deg = 180.0}).positions.size(), 8U);
}

TEST(CornerNormals, smoothing_groups_decide_and_group_zero_is_flat) {
  PolygonSoup soup = cube_soup();
  soup.smoothing_groups = {1, 2, 1, 1, 1, 1};
  // All but the side of group 2 are smooth; its four points have two normals.
  EXPECT_EQ(mesh_from_soup(soup, "x").positions.size(), 12U);
  soup.smoothing_groups.assign(6, 0);
  EXPECT_EQ(mesh_from_soup(soup, "x", {.smooth_below_deg = 180.0}).positions.size(), 24U);
}

TEST(CornerNormals, a_seam_of_doubled_points_is_smooth) {
  const Mesh sphere = make_sphere(16);
  PolygonSoup soup;
  for (const auto& t : sphere.triangles) {
    const auto first = static_cast<int32_t>(soup.points.size());
    for (const uint32_t vertex : t) soup.points.emplace_back(sphere.positions[vertex]);
    add_polygon(soup, {first, first + 1, first + 2});
  }
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_EQ(mesh.positions.size(), point_count(mesh));
}

TEST(CornerNormals, the_two_sides_of_a_sheet_stay_apart) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  for (const auto& quad : {std::vector{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 1, 0}, {4, 5, 2, 1}})
    add_polygon(soup, {quad.begin(), quad.end()});
  const Mesh mesh = mesh_from_soup(soup, "x", {.smooth_below_deg = 180.0});
  EXPECT_LT(largest_tilt(mesh), 0.01);
  EXPECT_EQ(mesh.positions.size(), 12U);
}

TEST(CornerNormals, a_sliver_along_a_sharp_edge_takes_no_part_in_the_shading) {
  // A cube's edge with a triangle of no height to speak of along it, as exporters of machine parts make.
  PolygonSoup soup = cube_soup();
  soup.points.emplace_back(0.0, -1.0, -1.0 + 1e-7);
  soup.corner_counts[2] = 5;  // 0 1 5 4: the new point stands between 0 and 1
  soup.corners.insert(soup.corners.begin() + 9, 8);
  add_polygon(soup, {0, 1, 8});
  soup.corners[soup.corners.size() - 3] = 0;
  const Mesh mesh = mesh_from_soup(soup, "x");
  for (const glm::vec3& normal : mesh.normals)
    EXPECT_GT(std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}), 0.999F);
}

TEST(Orientation, mixed_winding_is_mended_outwards_on_a_closed_mesh) {
  PolygonSoup soup = soup_of(make_sphere(12));
  for (size_t face = 0; face < soup.corner_counts.size(); face += 2)
    std::swap(soup.corners[3 * face], soup.corners[3 * face + 1]);
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_LT(largest_tilt(mesh), 30.0);
  for (size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_GT(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), 0.95F);
  EXPECT_THAT(mesh.notes, Contains(HasSubstr("faces over that lay against the neighbours")));
}

TEST(Orientation, an_inside_out_mesh_is_told_and_turned_where_that_is_asked) {
  const PolygonSoup soup = soup_of(make_inside_out_sphere(12));
  const Mesh kept = mesh_from_soup(soup, "x");
  EXPECT_LT(glm::dot(kept.normals[0], kept.positions[0]), 0.0F);
  EXPECT_THAT(kept.notes, Contains(HasSubstr("1 closed part faces inwards")));
  const Mesh turned = mesh_from_soup(soup, "x", {.outwards = true});
  EXPECT_GT(glm::dot(turned.normals[0], turned.positions[0]), 0.0F);
}

TEST(Orientation, faces_follow_the_normals_that_the_file_gives) {
  PolygonSoup soup = soup_of(make_inside_out_sphere(12));
  for (const glm::dvec3& point : soup.points) soup.normals.emplace_back(glm::normalize(point));
  soup.corner_normals = soup.corners;
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_LT(largest_tilt(mesh), 30.0);
  EXPECT_THAT(mesh.notes, Contains(HasSubstr("to the side that the file's normals show")));
}

TEST(Orientation, a_strip_with_one_side_is_left_as_it_is_and_told) {
  PolygonSoup soup;
  constexpr int kParts = 12;
  for (int i = 0; i < kParts; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kParts, half = turn / 2.0;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1.0 + side * std::cos(half);
      soup.points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), side * std::sin(half));
    }
  }
  for (int i = 0; i < kParts; ++i) {
    const int a = 2 * i, b = (2 * i + 2) % (2 * kParts);
    const bool joint = i + 1 == kParts;  // where the strip's two ends meet, upside down
    add_polygon(soup, {a, joint ? b + 1 : b, joint ? b : b + 1, a + 1});
  }
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_THAT(mesh.notes, Contains(HasSubstr("on a surface with one side")));
}

TEST(SoupPoints, far_and_tiny_and_huge_meshes_keep_their_shape) {
  for (const double scale : {1e-20, 1.0, 1e20}) {
    for (const double far : {0.0, 5e5}) {
      PolygonSoup soup = cube_soup();
      for (glm::dvec3& point : soup.points) point = scale * (point + glm::dvec3(far, -far, 2 * far));
      const Mesh mesh = mesh_from_soup(soup, "x");
      EXPECT_EQ(mesh.positions.size(), 24U);
      EXPECT_LT(largest_tilt(mesh), 0.01) << scale << " at " << far;
      for (size_t i = 0; i < 24; ++i) {
        const glm::dvec3 place = (mesh.origin + mesh.unit * glm::dvec3(mesh.positions[i])) / scale;
        EXPECT_NEAR(std::abs(place.x - far), 1.0, 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace inkbench
