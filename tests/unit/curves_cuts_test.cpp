// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "curves_support.h"

namespace inkbench {
namespace {

/// A mesh with its creases of 40 degrees.
std::unique_ptr<CurveSource> solid(const Mesh& mesh) {
  return std::make_unique<CurveSource>(mesh, CurvesParams{}, glm::dmat3(1.0));
}

size_t chain_count(const SurfaceCuts& cuts) {
  std::vector<glm::dvec3> points;
  for (const Piercing& piercing : cuts.piercings) points.push_back(piercing.at);
  return chain_links(points, cuts.pieces, 90.0).size();
}

TEST(SurfaceCuts, TwoSpheresCutInTheirCommonCircle) {
  const auto first = solid(make_sphere(64));
  const auto second = solid(make_sphere(64));
  // Radii 1 and 1, centres 1 apart: the circle lies half way, its radius is sqrt(3) / 2.
  const SurfaceCuts cuts = cut_surfaces(first->to_cut(), second->to_cut(),
                                        glm::translate(glm::dmat4(1.0), glm::dvec3(0.6, 0.8, 0.0)));
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
  EXPECT_EQ(chain_count(solid(both)->own_cuts()), 1U);
}

TEST(SurfaceCuts, WhatOnlyTouchesDoesNotCut) {
  const auto floor = solid(make_plane(8));
  const auto box = solid(make_box(2));
  // The box stands on the floor, its bottom in the floor's plane, and a hair above or below by rounding.
  for (const double off : {0.0, 1e-9, -1e-9}) {
    const SurfaceCuts cuts = cut_surfaces(
        floor->to_cut(), box->to_cut(),
        glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.03, 0.15 + off, 0.02)), glm::dvec3(0.3)));
    EXPECT_TRUE(cuts.pieces.empty()) << off;
  }
}

TEST(SurfaceCuts, ClosedMeshesThatDoNotCutThemselvesHaveNone) {
  for (const Mesh& mesh : {make_box(3), make_torus(24, 0.5F), make_sphere(20)}) {
    EXPECT_TRUE(solid(mesh)->own_cuts().pieces.empty());
  }
}

TEST(SurfaceCuts, ASphereWhoseEquatorLiesInAFloorsPlaneCutsItInOneRing) {
  const auto floor = solid(make_plane(7));
  const auto sphere = solid(make_sphere(32));
  const SurfaceCuts cuts =
      cut_surfaces(floor->to_cut(), sphere->to_cut(), glm::scale(glm::dmat4(1.0), glm::dvec3(0.37)));
  EXPECT_EQ(chain_count(cuts), 1U);
  double length = 0.0;
  for (const Link& piece : cuts.pieces)
    length += glm::distance(cuts.piercings[piece[0]].at, cuts.piercings[piece[1]].at);
  EXPECT_NEAR(length, 2 * 3.14159265 * 0.37, 0.01);
}

}  // namespace
}  // namespace inkbench
