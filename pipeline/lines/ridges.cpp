// SPDX-License-Identifier: MIT
// Ridges and valleys (Ohtake et al. 2004), as zeros of the derivative of a principal curvature.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "pipeline/lines/line_tracer.h"
#include "pipeline/lines/principal.h"
#include "pipeline/lines/smooth_lines.h"
#include "pipeline/lines/surface_gradient.h"

namespace inkbench {
namespace {

/// Of the surface as it is (`sign` 1: ridges) or turned inside out (-1: valleys), at each point. What takes
/// long is worked out where somebody asks.
class Extremality {
 public:
  Extremality(const SmoothSurface& surface, double sign)
      : surface_(surface),
        curvature_(surface.positions.size()),
        other_(surface.positions.size()),
        direction_(surface.positions.size()),
        derivative_(surface.positions.size(), kUnknown),
        second_(surface.positions.size(), kUnknown) {
    for (size_t i = 0; i < curvature_.size(); ++i) {
      const Principal principal = principal_of(surface.curvature[i], surface.normals[i], sign);
      curvature_[i] = principal.larger;
      other_[i] = principal.smaller;
      direction_[i] = principal.direction;
    }
  }

  /// The larger principal curvature, the smaller one, and the direction of the larger one: unit, its sign
  /// arbitrary.
  double curvature(uint32_t point) const { return curvature_[point]; }
  double other(uint32_t point) const { return other_[point]; }
  const glm::dvec3& direction(uint32_t point) const { return direction_[point]; }

  /// Of the larger one along that direction.
  double derivative(uint32_t point) {
    double& derivative = derivative_[point];
    if (std::isnan(derivative))
      derivative = glm::dot(gradient_at_point(surface_, curvature_, point), direction_[point]);
    return derivative;
  }

  /// The derivative's derivative along it; the directions of a face's corners are turned to agree first.
  double second(uint32_t point) {
    if (!std::isnan(second_[point])) return second_[point];
    double sum = 0.0, areas = 0.0;
    for (uint32_t i = surface_.face_starts[point]; i < surface_.face_starts[point + 1]; ++i) {
      const uint32_t f = surface_.point_faces[i];
      const std::array<uint32_t, 3>& face = surface_.faces[f];
      glm::dvec3 agreeing(0.0);
      for (int k = 0; k < 3; ++k) {
        const double side = glm::dot(direction_[face[k]], direction_[point]);
        agreeing[k] = side < 0.0 ? -derivative(face[k]) : derivative(face[k]);
      }
      const double area = glm::length(glm::cross(surface_.positions[face[1]] - surface_.positions[face[0]],
                                                 surface_.positions[face[2]] - surface_.positions[face[0]]));
      sum += area * glm::dot(gradient_on_face(surface_, f, agreeing), direction_[point]);
      areas += area;
    }
    return second_[point] = sum / (areas > 0.0 ? areas : 1.0);
  }

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  const SmoothSurface& surface_;
  std::vector<double> curvature_, other_;
  std::vector<glm::dvec3> direction_;
  std::vector<double> derivative_, second_;
};

class RidgeFinder {
 public:
  RidgeFinder(const SmoothSurface& surface, double sign, const SmoothLineParams& params)
      : surface_(surface), params_(params), extremality_(surface, sign), tracer_(surface.line_ids()) {}

  std::vector<Polyline3> find(LineClass line_class) {
    for (uint32_t f = 0; f < surface_.faces.size(); ++f) add_face(f);
    return of_class(line_class, tracer_.lines(params_.weak_share, params_.shortest * surface_.radius));
  }

 private:
  void add_face(uint32_t f) {
    const std::array<uint32_t, 3>& face = surface_.faces[f];
    for (const uint32_t point : face) {
      if (!(extremality_.curvature(point) > std::abs(extremality_.other(point)))) return;
    }
    std::array<LineTracer::Crossing, 3> found;
    size_t count = 0;
    for (size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      double share = 0.0;
      if (!has_zero(a, b, share)) continue;
      found[count++] = {surface_.crossings[f][i],
                        glm::mix(surface_.positions[a], surface_.positions[b], share), strength(a, b, share)};
    }
    if (count == 2) tracer_.add_step(f, found[0], found[1]);
    if (count == 3) add_meeting(f, found);
  }

  /// Three ridges meet in the middle of the face.
  void add_meeting(uint32_t f, const std::array<LineTracer::Crossing, 3>& found) {
    const LineTracer::Crossing middle = LineTracer::middle(surface_.crossing_count + f, found);
    for (const LineTracer::Crossing& crossing : found) tracer_.add_step(f, crossing, middle);
  }

  /// Whether the derivative changes its sign along an edge, once both directions agree; `share`: where. Signs
  /// alone decide, and 0 counts as positive, so that a line along the edges of a symmetric mesh, where the
  /// derivative is 0 up to rounding, is not lost. That it is a maximum, `strength` sees.
  bool has_zero(uint32_t a, uint32_t b, double& share) {
    const bool agree = glm::dot(extremality_.direction(a), extremality_.direction(b)) >= 0.0;
    const double at_a = extremality_.derivative(a), at_b = extremality_.derivative(b);
    const bool same_sign = (at_a >= 0.0) == (at_b >= 0.0);
    const double sizes = std::abs(at_a) + std::abs(at_b);
    share = sizes > 0.0 ? std::abs(at_a) / sizes : 0.5;
    return agree != same_sign;
  }

  double strength(uint32_t a, uint32_t b, double share) {
    const double curvature = glm::mix(extremality_.curvature(a), extremality_.curvature(b), share);
    const double other = glm::mix(extremality_.other(a), extremality_.other(b), share);
    if (std::abs(other) > params_.ridge_anisotropy * curvature) return 0.0;
    const double second = glm::mix(extremality_.second(a), extremality_.second(b), share);
    if (-second / (curvature * curvature * curvature) < params_.ridge_sharpness) return 0.0;
    return curvature * surface_.radius / params_.ridge_curvature;
  }

  const SmoothSurface& surface_;
  SmoothLineParams params_;
  Extremality extremality_;
  LineTracer tracer_;
};

}  // namespace

std::vector<Polyline3> ridges_and_valleys(const SmoothSurface& surface, const SmoothLineParams& params) {
  std::vector<Polyline3> lines = RidgeFinder(surface, 1.0, params).find(LineClass::ridge);
  for (Polyline3& valley : RidgeFinder(surface, -1.0, params).find(LineClass::valley))
    lines.push_back(std::move(valley));
  return lines;
}

}  // namespace inkbench
