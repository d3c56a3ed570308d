// SPDX-License-Identifier: MIT
// The built-in shapes against their analytic volume, area, normals and topology.
#include "pipeline/mesh/shapes/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace inkbench {
namespace {

constexpr double kPi = std::numbers::pi;

using Place = std::tuple<float, float, float>;

struct Topology {
  bool closed = true;  ///< Each directed edge once, and its opposite once.
  int euler = 0;
};

/// After welding vertices at exactly one place.
Topology topology_of(const Mesh& mesh) {
  std::map<Place, int> welded;
  std::vector<int> index;
  for (const glm::vec3& p : mesh.positions) {
    index.push_back(welded.try_emplace({p.x, p.y, p.z}, static_cast<int>(welded.size())).first->second);
  }
  std::map<std::pair<int, int>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++edges[{index[triangle[i]], index[triangle[(i + 1) % 3]]}];
  }
  Topology topology;
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    if (count != 1 || opposite == edges.end()) topology.closed = false;
  }
  topology.euler = static_cast<int>(welded.size()) - static_cast<int>(edges.size() / 2) +
                   static_cast<int>(mesh.triangles.size());
  return topology;
}

glm::dvec3 area_vector(const Mesh& mesh, const std::array<uint32_t, 3>& triangle) {
  const glm::dvec3 origin = mesh.positions[triangle[0]];
  return 0.5 * glm::cross(glm::dvec3(mesh.positions[triangle[1]]) - origin,
                          glm::dvec3(mesh.positions[triangle[2]]) - origin);
}

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& triangle : mesh.triangles) sum += glm::length(area_vector(mesh, triangle));
  return sum;
}

/// Divergence theorem; negative where faces look inwards.
double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& triangle : mesh.triangles) {
    sum += glm::dot(glm::dvec3(mesh.positions[triangle[0]]), area_vector(mesh, triangle)) / 3.0;
  }
  return sum;
}

/// Unit normals on the side that faces look to, no degenerate triangle, no unused vertex.
void expect_sound(const Mesh& mesh, double least_agreement) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  std::vector<bool> used(mesh.positions.size());
  for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0F, 1e-6F);
  for (const auto& triangle : mesh.triangles) {
    const glm::dvec3 facing = area_vector(mesh, triangle);
    ASSERT_GT(glm::length(facing), 1e-12);
    for (const uint32_t vertex : triangle) {
      ASSERT_LT(vertex, mesh.positions.size());
      used[vertex] = true;
      ASSERT_GT(glm::dot(glm::normalize(facing), glm::dvec3(mesh.normals[vertex])), least_agreement);
    }
  }
  EXPECT_EQ(std::ranges::count(used, false), 0);
  EXPECT_TRUE(mesh.notes.empty());
}

double rounded_box_volume(double r) {
  const double core = 1.0 - 2.0 * r;
  return core * core * core + 6.0 * core * core * r + 3.0 * kPi * core * r * r + 4.0 / 3.0 * kPi * r * r * r;
}

double rounded_box_area(double r) {
  const double core = 1.0 - 2.0 * r;
  return 6.0 * core * core + 6.0 * kPi * core * r + 4.0 * kPi * r * r;
}

TEST(Primitives, box_is_an_exact_closed_cube_with_sharp_normals) {
  for (const int segments : {1, 2, 7}) {
    const Mesh mesh = make_box(segments);
    EXPECT_EQ(mesh.triangles.size(), 12U * segments * segments);
    EXPECT_NEAR(volume(mesh), 1.0, 1e-6);
    EXPECT_NEAR(area(mesh), 6.0, 1e-6);
    expect_sound(mesh, 0.999999);
    const Topology topology = topology_of(mesh);
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.euler, 2);
  }
}

TEST(Primitives, plane_is_a_unit_square_facing_up) {
  for (const int segments : {1, 5}) {
    const Mesh mesh = make_plane(segments);
    EXPECT_EQ(mesh.triangles.size(), 2U * segments * segments);
    EXPECT_NEAR(area(mesh), 1.0, 1e-6);
    expect_sound(mesh, 0.999999);
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 1, 0));
    const Bounds bounds = bounds_of(mesh);
    EXPECT_EQ(bounds.low, glm::vec3(-0.5F, 0, -0.5F));
    EXPECT_EQ(bounds.high, glm::vec3(0.5F, 0, 0.5F));
  }
}

TEST(Primitives, sphere_is_closed_at_any_tessellation_and_its_points_and_normals_are_exact) {
  for (const int segments : {1, 2, 3, 4, 33}) {
    SCOPED_TRACE(segments);
    const Mesh mesh = make_sphere(segments);
    const Topology topology = topology_of(mesh);
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.euler, 2);
    expect_sound(mesh, 0.0);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      ASSERT_NEAR(glm::length(mesh.positions[i]), 1.0F, 1e-6F);
      ASSERT_EQ(mesh.positions[i], mesh.normals[i]);
    }
  }
}

TEST(Primitives, sphere_converges_with_the_square_of_its_segments) {
  const auto volume_error = [](int segments) { return 4.0 / 3.0 * kPi - volume(make_sphere(segments)); };
  EXPECT_GT(volume_error(64), 0.0);
  EXPECT_LT(volume_error(64), 0.01);
  EXPECT_NEAR(volume_error(32) / volume_error(64), 4.0, 0.1);
  EXPECT_NEAR(area(make_sphere(64)), 4.0 * kPi, 0.02);
}

TEST(Primitives, inside_out_sphere_mirrors_faces_and_normals) {
  const Mesh mesh = make_inside_out_sphere(16);
  expect_sound(mesh, 0.5);
  EXPECT_DOUBLE_EQ(volume(mesh), -volume(make_sphere(16)));
  EXPECT_EQ(mesh.normals[0], -mesh.positions[0]);
}

TEST(Primitives, torus_has_one_hole_and_its_analytic_volume_and_area) {
  for (const auto& [segments, tube] : {std::pair{1, 0.3F}, {2, 0.9F}, {3, 0.01F}, {20, 0.5F}}) {
    SCOPED_TRACE(segments);
    const Mesh mesh = make_torus(segments, tube);
    const Topology topology = topology_of(mesh);
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.euler, 0);
    EXPECT_GT(volume(mesh), 0.0);
  }
  const Mesh fine = make_torus(128, 0.25F);
  expect_sound(fine, 0.99);
  EXPECT_NEAR(volume(fine), 2.0 * kPi * kPi * 0.0625, 0.002);
  EXPECT_NEAR(area(fine), 4.0 * kPi * kPi * 0.25, 0.01);
  for (size_t i = 0; i < fine.positions.size(); ++i) {
    const glm::vec3 ring = fine.positions[i] - 0.25F * fine.normals[i];
    ASSERT_NEAR(glm::length(ring), 1.0F, 1e-6F);
    ASSERT_NEAR(ring.y, 0.0F, 1e-7F);
  }
}

TEST(Primitives, rounded_box_is_closed_for_every_fillet) {
  for (const float fillet : {1e-4F, 0.1F, 0.25F, 0.4999F, 0.5F}) {
    for (const int segments : {1, 2, 3, 8}) {
      SCOPED_TRACE(testing::Message() << "fillet " << fillet << ", segments " << segments);
      const Mesh mesh = make_rounded_box(segments, fillet);
      const Topology topology = topology_of(mesh);
      EXPECT_TRUE(topology.closed);
      EXPECT_EQ(topology.euler, 2);
      expect_sound(mesh, 0.5);
      EXPECT_EQ(bounds_of(mesh).low, glm::vec3(-0.5F));
      EXPECT_EQ(bounds_of(mesh).high, glm::vec3(0.5F));
      std::set<Place> places;
      for (const glm::vec3& p : mesh.positions) places.insert({p.x, p.y, p.z});
      EXPECT_EQ(places.size(), mesh.positions.size()) << "duplicated vertices";
    }
  }
}

TEST(Primitives, rounded_box_converges_to_its_analytic_volume_and_area) {
  for (const float fillet : {0.1F, 0.3F, 0.5F}) {
    const auto volume_error = [&](int segments) {
      return rounded_box_volume(fillet) - volume(make_rounded_box(segments, fillet));
    };
    EXPECT_LT(std::abs(volume_error(32)), 1e-3) << fillet;
    EXPECT_NEAR(volume_error(16) / volume_error(32), 4.0, 0.2) << fillet;
    EXPECT_NEAR(area(make_rounded_box(32, fillet)), rounded_box_area(fillet), 3e-3) << fillet;
  }
}

TEST(Primitives, rounded_box_normals_are_exact_and_its_sides_flat) {
  const double fillet = 0.2F;
  const Mesh mesh = make_rounded_box(6, 0.2F);
  double flat_area = 0.0;
  for (const auto& triangle : mesh.triangles) {
    bool flat = true;
    for (const uint32_t vertex : triangle) {
      const glm::dvec3 position = mesh.positions[vertex];
      const glm::dvec3 nearest_core =
          glm::clamp(position, glm::dvec3(fillet - 0.5), glm::dvec3(0.5 - fillet));
      ASSERT_NEAR(glm::distance(position, nearest_core), fillet, 1e-6);
      ASSERT_NEAR(glm::distance(glm::dvec3(mesh.normals[vertex]), (position - nearest_core) / fillet), 0.0,
                  1e-6);
      flat = flat && mesh.normals[vertex] == mesh.normals[triangle[0]];
    }
    if (flat) flat_area += glm::length(area_vector(mesh, triangle));
  }
  EXPECT_NEAR(flat_area, 6.0 * 0.6 * 0.6, 1e-6);
}

TEST(Primitives, rounded_box_without_fillet_is_the_box) {
  const Mesh rounded = make_rounded_box(3, 0.0F);
  const Mesh box = make_box(3);
  EXPECT_EQ(rounded.positions, box.positions);
  EXPECT_EQ(rounded.triangles, box.triangles);
}

TEST(Primitives, rounded_box_with_the_largest_fillet_is_a_sphere) {
  const Mesh mesh = make_rounded_box(9, 0.5F);
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    ASSERT_NEAR(glm::length(mesh.positions[i]), 0.5F, 1e-6F);
    ASSERT_NEAR(glm::distance(mesh.positions[i] * 2.0F, mesh.normals[i]), 0.0F, 1e-6F);
  }
}

}  // namespace
}  // namespace inkbench
