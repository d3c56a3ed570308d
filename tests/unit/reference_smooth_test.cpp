// SPDX-License-Identifier: MIT
// Curvature and lines of tier 2 on surfaces where they are known.
#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <numbers>

#include "pipeline/lines/line_tracer.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/reference_support.h"

namespace inkbench {
namespace {

SmoothSurface smooth(const Mesh& mesh, double smoothing = 0.0, const glm::dmat3& stretch = glm::dmat3(1.0)) {
  return make_smooth_surface(make_topology(mesh), kCreaseAngleDeg, smoothing, stretch);
}

glm::dvec3 any_tangent(const glm::dvec3& normal) {
  return glm::normalize(
      glm::cross(normal, std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
}

TEST(ReferenceCurvature, sphere_has_one_over_its_radius_everywhere) {
  Mesh sphere = make_rounded_box(24, 0.5F);  // radius 0.5, evenly divided
  // Smoothing moves normals where the mesh is unevenly fine, which costs up to a tenth.
  for (const auto& [smoothing, tolerance] : {std::pair{0.0, 0.03}, std::pair{2.0, 0.25}}) {
    const SmoothSurface surface = smooth(sphere, smoothing);
    for (size_t i = 0; i < surface.positions.size(); ++i) {
      const glm::dvec3 u = any_tangent(surface.normals[i]);
      const glm::dvec3 v = glm::cross(surface.normals[i], u);
      EXPECT_NEAR(quadratic_form(surface.curvature[i], u), 2.0, tolerance);
      EXPECT_NEAR(quadratic_form(surface.curvature[i], v), 2.0, tolerance);
    }
  }
}

TEST(ReferenceCurvature, torus_has_its_two_principal_curvatures) {
  const SmoothSurface surface = smooth(make_torus(64, 0.4F));
  for (size_t i = 0; i < surface.positions.size(); ++i) {
    const glm::dvec3& p = surface.positions[i];
    const double ring = std::hypot(p.x, p.z);
    const glm::dvec3 around(p.z / ring, 0.0, -p.x / ring);
    const glm::dvec3 out(p.x / ring, 0.0, p.z / ring);
    const double cosine = (ring - 1.0) / 0.4;
    const glm::dvec3 tube(-out.x * p.y / 0.4, cosine, -out.z * p.y / 0.4);
    EXPECT_NEAR(quadratic_form(surface.curvature[i], glm::normalize(tube)), 2.5, 0.05);
    EXPECT_NEAR(quadratic_form(surface.curvature[i], around), cosine / ring, 0.03);
  }
}

TEST(ReferenceCurvature, inside_out_surface_has_the_opposite_sign) {
  const SmoothSurface surface = smooth(make_inside_out_sphere(32));
  for (size_t i = 0; i < surface.positions.size(); ++i)
    EXPECT_LT(quadratic_form(surface.curvature[i], any_tangent(surface.normals[i])), -0.9);
}

TEST(ReferenceCurvature, stretched_sphere_is_an_ellipsoid) {
  glm::dmat3 stretch(1.0);
  stretch[1][1] = 2.0;
  const SmoothSurface surface = smooth(make_rounded_box(32, 0.5F), 0.0, stretch);
  for (size_t i = 0; i < surface.positions.size(); ++i) {  // half axes 0.5, 1, 0.5
    if (std::abs(surface.positions[i].y) > 0.999) {
      EXPECT_NEAR(quadratic_form(surface.curvature[i], {1, 0, 0}), 1.0 / (0.5 * 0.5), 0.2);
    }
    if (surface.positions[i].x > 0.4999) {
      EXPECT_NEAR(quadratic_form(surface.curvature[i], {0, 1, 0}), 0.5, 0.05);
    }
  }
}

Mesh noisy_sphere() {
  Mesh sphere = make_rounded_box(32, 0.5F);
  uint32_t state = 1;
  for (glm::vec3& position : sphere.positions) {
    state = state * 1664525U + 1013904223U;
    position *= 1.0F + 0.004F * (static_cast<float>(state >> 8) / 16777216.0F - 0.5F);
  }
  return sphere;
}

TEST(ReferenceCurvature, smoothing_removes_noise_and_keeps_the_form) {
  const Mesh sphere = noisy_sphere();
  const auto spread = [&](double smoothing) {
    const SmoothSurface surface = smooth(sphere, smoothing);
    double sum = 0.0;
    for (size_t i = 0; i < surface.positions.size(); ++i) {
      const double error = quadratic_form(surface.curvature[i], any_tangent(surface.normals[i])) - 2.0;
      sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(surface.positions.size()));
  };
  EXPECT_GT(spread(0.0), 0.3);
  EXPECT_LT(spread(2.0), spread(0.0) / 5.0);
}

TEST(ReferenceCurvature, creases_part_the_surface) {
  const SmoothSurface surface = smooth(make_box(6), 2.0);
  EXPECT_EQ(surface.positions.size(), 6U * 49U);
  for (size_t i = 0; i < surface.positions.size(); ++i) {
    EXPECT_NEAR(quadratic_form(surface.curvature[i], any_tangent(surface.normals[i])), 0.0, 1e-9);
  }
}

// ---- Suggestive contours

TEST(ReferenceSuggestive, surfaces_without_inflections_have_none) {
  for (const Mesh& mesh : {make_sphere(32), make_inside_out_sphere(32), make_box(8),
                           make_rounded_box(12, 0.2F), make_plane(9)}) {
    const MeshFeatures features = make_features(make_topology(mesh));
    EXPECT_TRUE(suggestive_contours(features, {2.0, 1.0, 3.0}).empty());
    EXPECT_TRUE(suggestive_contours(features, {0.1, 0.05, 0.02}).empty());
  }
}

/// Exact radial curvature of the torus of tube 0.4 at the point of the surface nearest to `p`.
double torus_radial_curvature(const glm::dvec3& p, const glm::dvec3& eye, double* cosine = nullptr) {
  const double ring = std::hypot(p.x, p.z);
  const glm::dvec3 out(p.x / ring, 0.0, p.z / ring);
  const glm::dvec3 around(p.z / ring, 0.0, -p.x / ring);
  const glm::dvec3 normal = glm::normalize(p - out);
  const glm::dvec3 point = out + 0.4 * normal;
  const glm::dvec3 view = glm::normalize(eye - point);
  const glm::dvec3 along = glm::normalize(view - normal * glm::dot(normal, view));
  const double share = glm::dot(along, around);
  if (cosine != nullptr) *cosine = glm::dot(normal, view);
  const double cos_v = glm::dot(normal, out);
  return cos_v / (1.0 + 0.4 * cos_v) * share * share + 2.5 * (1.0 - share * share);
}

TEST(ReferenceSuggestive, torus_has_them_where_its_radial_curvature_vanishes) {
  FeatureParams params;
  params.smoothing = 0.0;
  params.smooth_lines.suggestive_derivative = 0.3;
  params.smooth_lines.suggestive_angle_deg = 5.0;
  const MeshFeatures features = make_features(make_topology(make_torus(96, 0.4F)), params);
  const glm::dvec3 eye(0.0, 4.0, 3.0);
  const std::vector<Polyline3> lines = suggestive_contours(features, eye);
  std::vector<glm::dvec3> points;
  for (const Polyline3& line : lines) {
    EXPECT_EQ(line.line_class, LineClass::suggestive);
    for (const glm::dvec3& p : line.points) {
      points.push_back(p);
      double cosine = 0.0;
      EXPECT_NEAR(torus_radial_curvature(p, eye, &cosine), 0.0, 0.04);
      EXPECT_GT(cosine, 0.0);
      // Positive derivative towards the eye: a small step along the surface that way makes it convex.
      const glm::dvec3 out = glm::normalize(glm::dvec3(p.x, 0.0, p.z));
      const glm::dvec3 normal = glm::normalize(p - out);
      const glm::dvec3 view = glm::normalize(eye - p);
      const glm::dvec3 step = 0.03 * glm::normalize(view - normal * glm::dot(normal, view));
      EXPECT_GT(torus_radial_curvature(p + step, eye), torus_radial_curvature(p - step, eye));
    }
  }
  // And wherever it vanishes clearly, there is one.
  int clear = 0;
  for (int i = 0; i < 200; ++i) {
    const double around = 2.0 * std::numbers::pi * i / 200.0;
    const glm::dvec3 out(std::sin(around), 0.0, std::cos(around));
    for (int j = 0; j < 720; ++j) {
      const auto at = [&](double angle) {
        return out * (1.0 + 0.4 * std::cos(angle)) + glm::dvec3(0.0, 0.4 * std::sin(angle), 0.0);
      };
      const double v = 2.0 * std::numbers::pi * j / 720.0;
      const glm::dvec3 p = at(v);
      double cosine = 0.0;
      const double here = torus_radial_curvature(p, eye, &cosine);
      if ((here < 0.0) == (torus_radial_curvature(at(v + std::numbers::pi / 360.0), eye) < 0.0)) continue;
      const glm::dvec3 normal = glm::normalize(p - out);
      const glm::dvec3 view = glm::normalize(eye - p);
      const glm::dvec3 step = 0.01 * glm::normalize(view - normal * glm::dot(normal, view));
      const double derivative =
          (torus_radial_curvature(p + step, eye) - torus_radial_curvature(p - step, eye)) / 0.02;
      if (cosine < 0.1 || cosine > 0.97 || derivative < 0.3) continue;
      ++clear;
      double gap = 1.0;
      for (const glm::dvec3& point : points) gap = std::min(gap, glm::length(point - p));
      EXPECT_LT(gap, 0.06);
    }
  }
  EXPECT_GT(clear, 20);
}

TEST(ReferenceSuggestive, higher_threshold_leaves_less) {
  const MeshTopology torus = make_topology(make_torus(64, 0.4F));
  size_t before = 1000000;
  for (const double derivative : {0.3, 1.0, 3.0, 100.0}) {
    FeatureParams params;
    params.smooth_lines.suggestive_derivative = derivative;
    size_t points = 0;
    for (const Polyline3& line : suggestive_contours(make_features(torus, params), {0.0, 4.0, 3.0}))
      points += line.points.size();
    EXPECT_LE(points, before);
    before = points;
  }
  EXPECT_EQ(before, 0U);
}

// ---- Ridges and valleys

/// A roof whose ridge, along the line through the origin at `degrees` to the x axis, is rounded with radius
/// 0.06; turned over if `sign` is negative.
Mesh rounded_roof(double degrees, double sign) {
  Mesh mesh = make_plane(150);
  const double angle = glm::radians(degrees);
  for (glm::vec3& p : mesh.positions) {
    const double across = -std::sin(angle) * p.x + std::cos(angle) * p.z;
    p.y = static_cast<float>(-sign * std::sqrt(across * across + 0.06 * 0.06));
  }
  return mesh;
}

TEST(ReferenceRidges, rounded_roof_has_one_ridge_and_rounded_ditch_one_valley) {
  for (const double degrees : {0.0, 20.0, 45.0, 77.0}) {
    for (const double sign : {1.0, -1.0}) {
      const MeshFeatures features = make_features(make_topology(rounded_roof(degrees, sign)));
      EXPECT_TRUE(features.creases.empty());
      double length = 0.0;
      for (const Polyline3& line : features.ridges_and_valleys) {
        EXPECT_EQ(line.line_class, sign > 0.0 ? LineClass::ridge : LineClass::valley);
        for (size_t i = 0; i < line.points.size(); ++i) {
          const double angle = glm::radians(degrees);
          // Near the rim normals and averages are one-sided.
          const bool inside = std::max(std::abs(line.points[i].x), std::abs(line.points[i].z)) < 0.42;
          if (!inside) continue;
          EXPECT_LT(std::abs(-std::sin(angle) * line.points[i].x + std::cos(angle) * line.points[i].z),
                    0.004);
          if (i > 0) length += glm::length(line.points[i] - line.points[i - 1]);
        }
      }
      const double expected =
          1.0 / std::max(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)));
      EXPECT_GT(length, 0.80 * expected) << degrees;
      EXPECT_LT(length, 0.87 * expected) << degrees;
    }
  }
}

TEST(ReferenceRidges, surfaces_of_even_curvature_have_none) {
  for (const Mesh& mesh :
       {make_sphere(32), make_rounded_box(16, 0.5F), make_torus(48, 0.2F), make_box(8), make_plane(12)})
    EXPECT_TRUE(make_features(make_topology(mesh)).ridges_and_valleys.empty());
}

TEST(ReferenceRidges, thresholds_have_no_unit) {
  Mesh small = rounded_roof(20.0, 1.0);
  for (glm::vec3& position : small.positions) position *= 0.001F;
  const MeshFeatures a = make_features(make_topology(rounded_roof(20.0, 1.0)));
  const MeshFeatures b = make_features(make_topology(small));
  ASSERT_EQ(a.ridges_and_valleys.size(), b.ridges_and_valleys.size());
  for (size_t i = 0; i < a.ridges_and_valleys.size(); ++i)
    EXPECT_NEAR(glm::length(a.ridges_and_valleys[i].points[0] - 1000.0 * b.ridges_and_valleys[i].points[0]),
                0.0, 1e-3);
}

TEST(ReferenceRidges, rim_of_a_lens_is_one_closed_ridge) {
  Mesh lens = make_sphere(96);
  for (glm::vec3& position : lens.positions) position.y *= 0.3F;
  const MeshFeatures features = make_features(make_topology(lens));
  ASSERT_EQ(features.ridges_and_valleys.size(), 1U);
  const Polyline3& rim = features.ridges_and_valleys[0];
  EXPECT_EQ(rim.line_class, LineClass::ridge);
  EXPECT_EQ(rim.points.front(), rim.points.back());
  double length = 0.0;
  for (size_t i = 1; i < rim.points.size(); ++i) length += glm::length(rim.points[i] - rim.points[i - 1]);
  EXPECT_NEAR(length, 2.0 * std::numbers::pi, 0.05);
}

TEST(ReferenceRidges, noise_on_a_round_surface_is_no_ridge) {
  const MeshTopology sphere = make_topology(noisy_sphere());
  FeatureParams params;
  params.smooth_lines.ridge_curvature = 0.5;
  EXPECT_TRUE(make_features(sphere, params).ridges_and_valleys.empty());
  params.smooth_lines.ridge_anisotropy = 10.0;
  EXPECT_FALSE(make_features(sphere, params).ridges_and_valleys.empty());
}

TEST(ReferenceFeatures, stretch_is_that_of_a_stretched_mesh) {
  Mesh torus = make_torus(48, 0.4F);
  FeatureParams params;
  params.smooth_lines.suggestive_derivative = 0.3;
  params.stretch[1][1] = 1.7;
  const MeshFeatures stretched_later = make_features(make_topology(torus), params);
  for (glm::vec3& position : torus.positions) position.y *= 1.7F;
  params.stretch = glm::dmat3(1.0);
  const MeshFeatures stretched_first = make_features(make_topology(torus), params);
  const std::vector<Polyline3> later = suggestive_contours(stretched_later, {1.0, 3.0 / 1.7, 3.0});
  const std::vector<Polyline3> first = suggestive_contours(stretched_first, {1.0, 3.0, 3.0});
  ASSERT_EQ(later.size(), first.size());
  ASSERT_FALSE(later.empty());
  for (size_t i = 0; i < later.size(); ++i) {
    ASSERT_EQ(later[i].points.size(), first[i].points.size());
    for (size_t j = 0; j < later[i].points.size(); ++j)
      EXPECT_LT(glm::length(later[i].points[j] * glm::dvec3(1.0, 1.7, 1.0) - first[i].points[j]), 1e-3);
  }
}

// ---- What is strong enough

std::vector<SurfaceLine> traced(const std::vector<double>& strengths, bool closed, double weak,
                                double shortest) {
  LineTracer tracer(static_cast<uint32_t>(strengths.size()));
  const auto at = [&](size_t i) {
    return LineTracer::Crossing{static_cast<uint32_t>(i), glm::dvec3(static_cast<double>(i), 0.0, 0.0),
                                strengths[i]};
  };
  for (size_t i = 1; i < strengths.size(); ++i) tracer.add_step(static_cast<uint32_t>(i), at(i - 1), at(i));
  if (closed) tracer.add_step(0, at(strengths.size() - 1), at(0));
  return tracer.lines(weak, shortest);
}

TEST(ReferenceTracer, line_goes_on_down_to_the_weak_share_if_it_is_strong_somewhere) {
  const std::vector<SurfaceLine> lines =
      traced({0.6, 1.1, 0.7, 0.2, 0.9, 0.9, 0.4, 1.0, 2.0}, false, 0.5, 0.0);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].points.size(), 3U);
  EXPECT_EQ(lines[1].points.size(), 2U);
  EXPECT_EQ(lines[1].points[0].x, 7.0);
}

TEST(ReferenceTracer, short_lines_are_dropped) {
  EXPECT_EQ(traced({1.0, 1.0, 1.0, 0.0, 1.0, 1.0}, false, 0.5, 1.5).size(), 1U);
  EXPECT_TRUE(traced({0.0, 1.0, 0.0}, false, 0.5, 0.0).empty());
}

TEST(ReferenceTracer, run_across_the_start_of_a_ring_is_one_line) {
  const std::vector<SurfaceLine> lines = traced({2.0, 2.0, 0.1, 2.0, 2.0}, true, 0.5, 0.0);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].points.size(), 4U);
  const std::vector<SurfaceLine> ring = traced({2.0, 2.0, 2.0, 2.0}, true, 0.5, 0.0);
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_EQ(ring[0].points.front(), ring[0].points.back());
}

TEST(ReferenceTracer, lines_name_the_edges_they_cross_and_the_faces_between) {
  const std::vector<SurfaceLine> line = traced({0.1, 1.0, 1.0, 1.0}, false, 0.5, 0.0);
  ASSERT_EQ(line.size(), 1U);
  EXPECT_EQ(line[0].crossings, (std::vector<uint32_t>{1, 2, 3}));
  EXPECT_EQ(line[0].faces, (std::vector<uint32_t>{2, 3}));
  const std::vector<SurfaceLine> ring =
      traced({2.0, 2.0, 1.0, 2.0}, true, 0.5, 0.0);  // from its weakest point
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_EQ(ring[0].crossings.front(), 2U);
  ASSERT_EQ(ring[0].faces.size(), 4U);
  for (size_t i = 0; i < 4; ++i) {
    const auto [a, b] = std::minmax(ring[0].crossings[i], ring[0].crossings[i + 1]);
    EXPECT_EQ(ring[0].faces[i], a == 0 && b == 3 ? 0U : b);
  }
}

TEST(ReferenceTracer, smooth_lines_run_from_edge_to_edge_of_the_faces_they_name) {
  FeatureParams params;
  params.smooth_lines.suggestive_derivative = 0.3;
  const MeshFeatures features = make_features(make_topology(make_torus(96, 0.4F)), params);
  const std::vector<Polyline3> lines = suggestive_contours(features, {0.0, 4.0, 3.0});
  ASSERT_FALSE(lines.empty());
  for (const Polyline3& line : lines) {
    ASSERT_EQ(line.crossings.size(), line.points.size());
    ASSERT_EQ(line.faces.size() + 1, line.points.size());
    for (size_t i = 0; i < line.faces.size(); ++i) {
      const std::array<uint32_t, 3>& edges = features.surface.crossings[line.faces[i]];
      EXPECT_NE(std::find(edges.begin(), edges.end(), line.crossings[i]), edges.end());
      EXPECT_NE(std::find(edges.begin(), edges.end(), line.crossings[i + 1]), edges.end());
    }
  }
}

}  // namespace
}  // namespace inkbench
