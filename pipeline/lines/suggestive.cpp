// SPDX-License-Identifier: MIT
// Suggestive contours (DeCarlo et al. 2003).
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "pipeline/lines/line_tracer.h"
#include "pipeline/lines/smooth_lines.h"

namespace inkbench {
namespace {

/// What the eye sees at each point.
struct Radial {
  std::vector<double> curvature;      ///< Normal curvature in the direction towards the eye.
  std::vector<glm::dvec3> direction;  ///< Unit, along the surface, towards the eye.
  std::vector<double> cosine;         ///< Of the angle between normal and view.
};

Radial radial_of(const SmoothSurface& surface, const Viewpoint& eye) {
  Radial radial;
  const size_t count = surface.positions.size();
  radial.curvature.resize(count);
  radial.direction.resize(count);
  radial.cosine.resize(count);
  for (size_t i = 0; i < count; ++i) {
    const glm::dvec3 to_eye = eye.from(surface.positions[i]);
    const double distance = glm::length(to_eye);
    const glm::dvec3 view = distance > 0.0 ? to_eye / distance : surface.normals[i];
    radial.cosine[i] = glm::dot(surface.normals[i], view);
    const glm::dvec3 along = view - surface.normals[i] * radial.cosine[i];
    const double length = glm::length(along);
    radial.direction[i] = length > 1e-9 ? along / length : glm::dvec3(0.0);
    radial.curvature[i] = quadratic_form(surface.curvature[i], radial.direction[i]);
  }
  return radial;
}

}  // namespace

std::vector<Polyline3> suggestive_contours(const SmoothSurface& surface, const Viewpoint& eye,
                                           const SmoothLineParams& params) {
  const Radial radial = radial_of(surface, eye);
  const std::vector<glm::dvec3> gradients = gradient_at_points(surface, radial.curvature);
  const double least_derivative = params.suggestive_derivative / (surface.radius * surface.radius);
  const double largest_cosine = std::cos(glm::radians(params.suggestive_angle_deg));
  const auto strength = [&](uint32_t a, uint32_t b, double share) {
    const double cosine = glm::mix(radial.cosine[a], radial.cosine[b], share);
    if (!(cosine > 0.0) || cosine > largest_cosine) return 0.0;
    return glm::mix(glm::dot(gradients[a], radial.direction[a]), glm::dot(gradients[b], radial.direction[b]),
                    share) /
           least_derivative;
  };
  LineTracer tracer;
  for (uint32_t f = 0; f < surface.faces.size(); ++f) {
    const std::array<uint32_t, 3>& face = surface.faces[f];
    std::array<LineTracer::Crossing, 3> found;
    size_t count = 0;
    for (size_t i = 0; i < 3; ++i) {
      // From the smaller index on, so that both faces of an edge compute the same place.
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      const double at_a = radial.curvature[a];
      const double at_b = radial.curvature[b];
      if ((at_a < 0.0) == (at_b < 0.0)) continue;
      const double share = at_a / (at_a - at_b);
      found[count++] = {surface.crossings[f][i], glm::mix(surface.positions[a], surface.positions[b], share),
                        strength(a, b, share)};
    }
    if (count == 2) tracer.add_step(found[0], found[1]);
  }
  return tracer.lines(LineClass::suggestive, params.weak_share, params.shortest * surface.radius);
}

}  // namespace inkbench
