// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "curves_support.h"
#include "pipeline/lines/mesh_lines.h"

namespace inkbench {
namespace {

/// Möller and Trumbore's test, which knows no tree.
int brute_force_count(const MeshTopology& topology, const Ray& ray) {
  int count = 0;
  for (const auto& face : topology.faces) {
    const glm::dvec3& a = topology.positions[face[0]];
    const glm::dvec3 u = topology.positions[face[1]] - a;
    const glm::dvec3 v = topology.positions[face[2]] - a;
    const glm::dvec3 p = glm::cross(ray.direction, v);
    const double turn = glm::dot(u, p);
    if (turn == 0.0) continue;
    const glm::dvec3 from = ray.origin - a;
    const double along_u = glm::dot(from, p) / turn;
    const glm::dvec3 q = glm::cross(from, u);
    const double along_v = glm::dot(ray.direction, q) / turn;
    const double t = glm::dot(v, q) / turn;
    if (along_u > 0.0 && along_v > 0.0 && along_u + along_v < 1.0 && t > ray.from && t < ray.to) ++count;
  }
  return count;
}

TEST(TriangleTree, CountsTheFacesThatARayPassesAsATestOfEveryFaceDoes) {
  const MeshTopology topology = make_topology(rough_sphere(16, 0.4, 1));
  const TriangleTree tree(topology);
  const std::vector<glm::dvec3> ends = random_points(2000, 2.0, 2);
  int passed = 0;
  for (size_t i = 0; i + 1 < ends.size(); ++i) {
    const Ray ray{ends[i], ends[i + 1] - ends[i], 0.0, 1.0};
    const int counted = tree.count_passed(ray, ends[i + 1]);
    ASSERT_EQ(counted, brute_force_count(topology, ray)) << i;
    passed += counted;
  }
  EXPECT_GT(passed, 1000);
}

TEST(TriangleTree, MeetsAClosedMeshAnEvenNumberOfTimesAlsoThroughItsEdgesAndVertices) {
  const MeshTopology topology = make_topology(make_box(4));
  const TriangleTree tree(topology);
  for (int axis = 0; axis < 3; ++axis) {
    // Through every point of the grid and every half-way point of its edges and diagonals.
    for (int i = -5; i <= 5; ++i) {
      for (int j = -5; j <= 5; ++j) {
        glm::dvec3 from(-3.0);
        from[(axis + 1) % 3] = i / 8.0;
        from[(axis + 2) % 3] = j / 8.0;
        glm::dvec3 direction(0.0);
        direction[axis] = 6.0;
        const int count = tree.count_passed({from, direction, 0.0, 1.0}, from + direction);
        const bool is_within = std::abs(i) < 4 && std::abs(j) < 4;
        ASSERT_EQ(count % 2, 0) << axis << ' ' << i << ' ' << j;
        if (is_within) {
          ASSERT_EQ(count, 2) << axis << ' ' << i << ' ' << j;
        }
      }
    }
  }
}

TEST(TriangleTree, DoesNotCountAFaceOnWhoseSurfaceTheRayEnds) {
  const MeshTopology topology = make_topology(make_box(1));
  const TriangleTree tree(topology);
  const glm::dvec3 eye(0.2, 0.1, 3.0);
  for (const double x : {-0.5, -0.1, 0.5}) {
    const glm::dvec3 on_front(x, 0.3, 0.5);
    EXPECT_EQ(tree.count_passed({eye, on_front - eye, 0.0, 1.0}, on_front), 0) << x;
  }
  const glm::dvec3 on_back(0.1, 0.1, -0.5);
  EXPECT_EQ(tree.count_passed({eye, on_back - eye, 0.0, 1.0}, on_back), 1);
}

/// Meshes of every kind: closed, open, with edges of three and four faces, with faces turned round.
std::vector<MeshTopology> all_kinds() {
  std::vector<MeshTopology> kinds;
  for (const Mesh& mesh : {make_box(3), make_torus(24, 0.4F), make_plane(5), rough_sphere(20, 0.2, 3),
                           make_inside_out_sphere(12)})
    kinds.push_back(make_topology(mesh));
  Mesh fins = make_plane(2);  // a third and a fourth face on one of its edges, and one turned round
  const auto count = static_cast<uint32_t>(fins.positions.size());
  fins.positions.emplace_back(0.0F, 0.7F, 0.1F);
  fins.positions.emplace_back(0.1F, -0.6F, 0.0F);
  fins.normals.resize(fins.positions.size(), {0.0F, 1.0F, 0.0F});
  const auto first = fins.triangles[0];
  fins.triangles.push_back({first[0], first[1], count});
  fins.triangles.push_back({first[1], first[0], count + 1});
  std::swap(fins.triangles[3][0], fins.triangles[3][1]);
  kinds.push_back(make_topology(fins));
  return kinds;
}

TEST(SilhouetteTree, FindsExactlyTheEdgesThatALookAtEveryEdgeFinds) {
  size_t found = 0;
  for (const MeshTopology& topology : all_kinds()) {
    const EdgeSilhouettes silhouettes(topology);
    for (const glm::dvec3& place : random_points(60, 2.5, 4)) {
      for (const Viewpoint& eye : {Viewpoint(place), Viewpoint::at_infinity(place)}) {
        for (const bool mirrored : {false, true}) {
          const std::vector<uint32_t> expected =
              silhouette_edges(topology, face_facings(topology, eye, mirrored));
          ASSERT_EQ(silhouettes.find(topology, eye, mirrored), expected);
          found += expected.size();
        }
      }
    }
  }
  EXPECT_GT(found, 1000U);
}

TEST(SilhouetteTree, LooksAtAShareOfTheNodesThatShrinksAsFacesGrow) {
  // Silhouettes grow with the square root of the faces; so do the nodes around them.
  const glm::dvec3 eye(4.0, 1.5, 2.0);
  std::vector<size_t> visited;
  for (const int segments : {32, 64, 128, 256}) {
    const MeshTopology topology = make_topology(make_sphere(segments));
    visited.push_back(EdgeSilhouettes(topology).tree.visited(eye));
  }
  for (size_t i = 1; i < visited.size(); ++i) {
    EXPECT_LT(static_cast<double>(visited[i]), 2.6 * static_cast<double>(visited[i - 1]))
        << "four times the faces";
  }
}

TEST(SmoothSilhouettes, RunWhereTheSphereTurnsAwayWhateverTheMesh) {
  const glm::dvec3 eye(3.0, 1.0, 2.0);
  const MeshTopology topology = make_topology(make_sphere(40));
  const SmoothSurface surface = make_smooth_surface(topology, 40.0, 2.0, glm::dmat3(1.0));
  const std::vector<SurfaceLine> lines = SmoothSilhouettes(surface).find(surface, eye);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].points.front(), lines[0].points.back()) << "one ring";
  const double plane = 1.0 / glm::length(eye);  // the circle of contact lies in this plane
  for (const glm::dvec3& point : lines[0].points)
    EXPECT_NEAR(glm::dot(point, glm::normalize(eye)), plane, 2e-3);
}

TEST(SmoothSilhouettes, AreThoseThatALookAtEveryFaceFinds) {
  const MeshTopology topology = make_topology(rough_sphere(24, 0.15, 7));
  const SmoothSurface surface = make_smooth_surface(topology, 60.0, 0.0, glm::dmat3(1.0));
  const SmoothSilhouettes silhouettes(surface);
  for (const glm::dvec3& place : random_points(40, 2.5, 8)) {
    const Viewpoint eye(place);
    size_t crossed = 0;
    for (const auto& face : surface.faces) {
      int towards = 0;
      for (const uint32_t point : face)
        towards += glm::dot(surface.point_normals[point], eye.from(surface.positions[point])) >= 0.0 ? 1 : 0;
      if (towards == 1 || towards == 2) ++crossed;
    }
    size_t steps = 0;
    for (const SurfaceLine& line : silhouettes.find(surface, eye)) steps += line.faces.size();
    ASSERT_EQ(steps, crossed);
  }
}

}  // namespace
}  // namespace inkbench
