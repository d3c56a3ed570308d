// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "curves_support.h"

namespace inkbench {
namespace {

struct Solid {
  MeshTopology topology;
  TriangleTree tree;
  explicit Solid(const Mesh& mesh) : topology(make_topology(mesh)), tree(topology) {}
};

TEST(SurfaceCuts, TwoSpheresCutInTheirCommonCircle) {
  const Solid first(make_sphere(64));
  const Solid second(make_sphere(64));
  // Radii 1 and 1, centres 1 apart: the circle lies half way, its radius is sqrt(3) / 2.
  const SurfaceCuts cuts =
      cut_surfaces(first.tree, second.tree, glm::translate(glm::dmat4(1.0), glm::dvec3(0.6, 0.8, 0.0)));
  ASSERT_GT(cuts.pieces.size(), 100U);
  double length = 0.0;
  for (const Link& piece : cuts.pieces) {
    const glm::dvec3& a = cuts.piercings[piece[0]].at;
    const glm::dvec3& b = cuts.piercings[piece[1]].at;
    EXPECT_NEAR(glm::dot(a, glm::dvec3(0.6, 0.8, 0.0)), 0.5, 2e-3);
    EXPECT_NEAR(glm::length(a), 1.0, 2e-3);
    length += glm::distance(a, b);
  }
  EXPECT_NEAR(length, 3.14159265 * std::sqrt(3.0), 0.01);
  std::vector<glm::dvec3> points;
  for (const Piercing& piercing : cuts.piercings) points.push_back(piercing.at);
  const std::vector<Chain> chains = chain_links(points, cuts.pieces, 90.0);
  ASSERT_EQ(chains.size(), 1U) << "one ring without gaps";
  EXPECT_EQ(chains[0].front(), chains[0].back());
}

TEST(SurfaceCuts, AMeshOfTwoSpheresCutsItself) {
  Mesh both = make_sphere(24);
  const Mesh other = make_sphere(24);
  const auto count = static_cast<uint32_t>(both.positions.size());
  for (const glm::vec3& point : other.positions)
    both.positions.push_back(point + glm::vec3(0.9F, 0.2F, 0.1F));
  both.normals.insert(both.normals.end(), other.normals.begin(), other.normals.end());
  for (const auto& face : other.triangles)
    both.triangles.push_back({face[0] + count, face[1] + count, face[2] + count});
  const Solid solid(both);
  const SurfaceCuts cuts = cut_with_itself(solid.tree);
  std::vector<glm::dvec3> points;
  for (const Piercing& piercing : cuts.piercings) points.push_back(piercing.at);
  EXPECT_EQ(chain_links(points, cuts.pieces, 90.0).size(), 1U);
}

TEST(SurfaceCuts, WhatOnlyTouchesDoesNotCut) {
  const Solid floor(make_plane(8));
  const Solid box(make_box(2));
  // The box stands on the floor, its bottom in the floor's plane, and a hair above or below by rounding.
  for (const double off : {0.0, 1e-9, -1e-9}) {
    const SurfaceCuts cuts = cut_surfaces(
        floor.tree, box.tree,
        glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.03, 0.15 + off, 0.02)), glm::dvec3(0.3)));
    EXPECT_TRUE(cuts.pieces.empty()) << off;
  }
}

TEST(SurfaceCuts, ClosedMeshesThatDoNotCutThemselvesHaveNone) {
  for (const Mesh& mesh : {make_box(3), make_torus(24, 0.5F), make_sphere(20)}) {
    const Solid solid(mesh);
    EXPECT_TRUE(cut_with_itself(solid.tree).pieces.empty());
  }
}

}  // namespace
}  // namespace inkbench
