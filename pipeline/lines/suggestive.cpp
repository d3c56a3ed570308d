// SPDX-License-Identifier: MIT
// Suggestive contours (DeCarlo et al. 2003).
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "pipeline/lines/line_tracer.h"
#include "pipeline/lines/smooth_lines.h"
#include "pipeline/lines/surface_gradient.h"

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

class SuggestiveFinder {
 public:
  SuggestiveFinder(const SmoothSurface& surface, const Viewpoint& eye, const SmoothLineParams& params)
      : surface_(surface),
        radial_(radial_of(surface, eye)),
        towards_eye_(surface.positions.size(), std::numeric_limits<double>::quiet_NaN()),
        least_derivative_(params.suggestive_derivative / (surface.radius * surface.radius)),
        largest_cosine_(std::cos(glm::radians(params.suggestive_angle_deg))),
        tracer_(surface.line_ids()) {}

  std::vector<SurfaceLine> find(double weak, double shortest) {
    for (uint32_t f = 0; f < surface_.faces.size(); ++f) add_face(f);
    return tracer_.lines(weak, shortest);
  }

 private:
  void add_face(uint32_t f) {
    const std::array<uint32_t, 3>& face = surface_.faces[f];
    const auto is_concave = [&](size_t i) { return radial_.curvature[face[i]] < 0.0; };
    if (is_concave(0) == is_concave(1) && is_concave(1) == is_concave(2)) return;
    std::array<LineTracer::Crossing, 3> found;
    size_t count = 0;
    for (size_t i = 0; i < 3; ++i) {
      // From the smaller index on, so that both faces of an edge compute the same place.
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      const double at_a = radial_.curvature[a];
      const double at_b = radial_.curvature[b];
      if ((at_a < 0.0) == (at_b < 0.0)) continue;
      const double share = at_a / (at_a - at_b);
      found[count++] = {surface_.crossings[f][i],
                        glm::mix(surface_.positions[a], surface_.positions[b], share), strength(a, b, share)};
    }
    if (count == 2) tracer_.add_step(f, found[0], found[1]);
  }

  double strength(uint32_t a, uint32_t b, double share) {
    const double cosine = glm::mix(radial_.cosine[a], radial_.cosine[b], share);
    if (!(cosine > 0.0) || cosine > largest_cosine_) return 0.0;
    return glm::mix(towards_eye(a), towards_eye(b), share) / least_derivative_;
  }

  /// The curvature's derivative in that direction, worked out where somebody asks.
  double towards_eye(uint32_t point) {
    double& derivative = towards_eye_[point];
    if (std::isnan(derivative))
      derivative = glm::dot(gradient_at_point(surface_, radial_.curvature, point), radial_.direction[point]);
    return derivative;
  }

  const SmoothSurface& surface_;
  Radial radial_;
  std::vector<double> towards_eye_;
  double least_derivative_, largest_cosine_;
  LineTracer tracer_;
};

}  // namespace

std::vector<Polyline3> suggestive_contours(const SmoothSurface& surface, const Viewpoint& eye,
                                           const SmoothLineParams& params) {
  SuggestiveFinder finder(surface, eye, params);
  return of_class(LineClass::suggestive, finder.find(params.weak_share, params.shortest * surface.radius));
}

}  // namespace inkbench
