// SPDX-License-Identifier: MIT
// What tests of curves share: scenes of meshes and the curves of them, and meshes to try.
#pragma once

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <random>

#include "pipeline/curves/curve_finder.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {

/// The eye 6 before the origin on the z axis, a view of 90 degrees, 400 x 400 px unless changed: a length of
/// 1 in the plane z = 0 is 400 / 12 px.
class CurveScene {
 public:
  CurveRequest request;

  CurveScene() {
    request.width_px = request.height_px = 400;
    request.camera.eye = {0.0F, 0.0F, 6.0F};
    request.camera.fov = 90.0F;
  }

  CurveScene& add(Mesh mesh, const glm::mat4& to_world = glm::mat4(1.0F)) {
    const auto id = static_cast<int>(request.models.size()) + 1;
    request.models.push_back({std::make_shared<Mesh>(std::move(mesh)),
                              KeyBuilder().add("mesh " + std::to_string(id)).key(), to_world, id});
    return *this;
  }

  Curves find() const {
    CurveFinder finder;
    return finder.find(request);
  }
};

inline glm::mat4 moved(float x, float y, float z, float scale = 1.0F) {
  return glm::scale(glm::translate(glm::mat4(1.0F), {x, y, z}), glm::vec3(scale));
}

/// Of all curves of a class, visible or not.
inline double length_of(const Curves& curves, CurveClass curve_class, bool visible) {
  double length = 0.0;
  for (const Curve& curve : curves.curves) {
    if (curve.curve_class == curve_class && (curve.covered == 0) == visible) length += length_px(curve);
  }
  return length;
}

/// A sphere whose points are moved at random: many silhouettes run to and fro, many edges are hollow.
inline Mesh rough_sphere(int segments, double roughness, unsigned seed) {
  Mesh mesh = make_sphere(segments);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> jitter(1.0F - static_cast<float>(roughness),
                                               1.0F + static_cast<float>(roughness));
  for (glm::vec3& point : mesh.positions) point *= jitter(random);
  return mesh;
}

inline std::vector<glm::dvec3> random_points(size_t count, double reach, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-reach, reach);
  std::vector<glm::dvec3> points;
  for (size_t i = 0; i < count; ++i) points.emplace_back(place(random), place(random), place(random));
  return points;
}

}  // namespace inkbench
