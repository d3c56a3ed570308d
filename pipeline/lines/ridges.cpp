// SPDX-License-Identifier: MIT
// Ridges and valleys (Ohtake et al. 2004), as zeros of the derivative of a principal curvature.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/lines/line_tracer.h"
#include "pipeline/lines/principal.h"
#include "pipeline/lines/smooth_lines.h"

namespace inkbench {
namespace {

/// Of the surface as it is (`sign` 1: ridges) or turned inside out (-1: valleys), at each point.
struct Extremality {
  std::vector<double> curvature;      ///< The larger principal curvature.
  std::vector<double> other;          ///< The smaller one.
  std::vector<glm::dvec3> direction;  ///< Of the larger one; unit, its sign arbitrary.
  std::vector<double> derivative;     ///< Of the larger one along that direction.
  std::vector<double> second;         ///< The derivative's derivative along it.
};

void find_principal(const SmoothSurface& surface, double sign, Extremality& result) {
  const size_t count = surface.positions.size();
  result.curvature.resize(count);
  result.other.resize(count);
  result.direction.resize(count);
  for (size_t i = 0; i < count; ++i) {
    const Principal principal = principal_of(surface.curvature[i], surface.normals[i], sign);
    result.curvature[i] = principal.larger;
    result.other[i] = principal.smaller;
    result.direction[i] = principal.direction;
  }
}

/// The derivative's own derivative; the directions of a face's corners are turned to agree first.
void find_second(const SmoothSurface& surface, Extremality& result) {
  const size_t count = surface.positions.size();
  std::vector<double> weights(count, 0.0);
  result.second.assign(count, 0.0);
  for (uint32_t f = 0; f < surface.faces.size(); ++f) {
    const std::array<uint32_t, 3>& face = surface.faces[f];
    for (const uint32_t point : face) {
      glm::dvec3 agreeing(0.0);
      for (int i = 0; i < 3; ++i) {
        const double side = glm::dot(result.direction[face[i]], result.direction[point]);
        agreeing[i] = side < 0.0 ? -result.derivative[face[i]] : result.derivative[face[i]];
      }
      const glm::dvec3 gradient = gradient_on_face(surface, f, agreeing);
      const double area = glm::length(glm::cross(surface.positions[face[1]] - surface.positions[face[0]],
                                                 surface.positions[face[2]] - surface.positions[face[0]]));
      result.second[point] += area * glm::dot(gradient, result.direction[point]);
      weights[point] += area;
    }
  }
  for (size_t i = 0; i < count; ++i) result.second[i] /= weights[i] > 0.0 ? weights[i] : 1.0;
}

Extremality extremality_of(const SmoothSurface& surface, double sign) {
  Extremality result;
  find_principal(surface, sign, result);
  const std::vector<glm::dvec3> gradients = gradient_at_points(surface, result.curvature);
  result.derivative.resize(surface.positions.size());
  for (size_t i = 0; i < gradients.size(); ++i)
    result.derivative[i] = glm::dot(gradients[i], result.direction[i]);
  find_second(surface, result);
  return result;
}

class RidgeFinder {
 public:
  RidgeFinder(const SmoothSurface& surface, double sign, const SmoothLineParams& params)
      : surface_(surface),
        params_(params),
        extremality_(extremality_of(surface, sign)),
        tracer_(surface.line_ids()) {}

  std::vector<Polyline3> find(LineClass line_class) {
    for (uint32_t f = 0; f < surface_.faces.size(); ++f) add_face(f);
    return of_class(line_class, tracer_.lines(params_.weak_share, params_.shortest * surface_.radius));
  }

 private:
  void add_face(uint32_t f) {
    const std::array<uint32_t, 3>& face = surface_.faces[f];
    for (const uint32_t point : face) {
      if (!(extremality_.curvature[point] > std::abs(extremality_.other[point]))) return;
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
  bool has_zero(uint32_t a, uint32_t b, double& share) const {
    const bool agree = glm::dot(extremality_.direction[a], extremality_.direction[b]) >= 0.0;
    const bool same_sign = (extremality_.derivative[a] >= 0.0) == (extremality_.derivative[b] >= 0.0);
    const double size_a = std::abs(extremality_.derivative[a]);
    const double size_b = std::abs(extremality_.derivative[b]);
    share = size_a + size_b > 0.0 ? size_a / (size_a + size_b) : 0.5;
    return agree != same_sign;
  }

  double strength(uint32_t a, uint32_t b, double share) const {
    const auto between = [&](const std::vector<double>& values) {
      return glm::mix(values[a], values[b], share);
    };
    const double curvature = between(extremality_.curvature);
    if (std::abs(between(extremality_.other)) > params_.ridge_anisotropy * curvature) return 0.0;
    const double sharpness = -between(extremality_.second) / (curvature * curvature * curvature);
    if (sharpness < params_.ridge_sharpness) return 0.0;
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
