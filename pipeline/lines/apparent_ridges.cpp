// SPDX-License-Identifier: MIT
#include "pipeline/lines/apparent_ridges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/lines/line_tracer.h"
#include "pipeline/lines/principal.h"
#include "pipeline/lines/surface_gradient.h"

namespace inkbench {
namespace {

constexpr double kLeastCosine = 1e-3;
/// Nearer to the contour than this (cosine) the contour itself is the line.
constexpr double kContourCosine = 0.1;

class ApparentRidgeFinder {
 public:
  ApparentRidgeFinder(const SmoothSurface& surface, const Viewpoint& eye, const ApparentRidgeParams& params)
      : surface_(surface),
        eye_(eye),
        params_(params),
        reach_(surface.positions.size()),
        size_(surface.positions.size(), kUnknown),
        direction_(surface.positions.size()),
        uphill_(surface.positions.size()),
        tracer_(surface.line_ids()) {}

  std::vector<SurfaceLine> find() {
    for (uint32_t point = 0; point < reach_.size(); ++point) reach_[point] = reach_at(point);
    for (uint32_t f = 0; f < surface_.faces.size(); ++f) add_face(f);
    return tracer_.lines(params_.weak_share, params_.shortest);
  }

 private:
  static constexpr double kUnknown = -1.0;
  /// What can be said of a point before its q1 is worked out, which takes longest.
  enum class Reach : uint8_t { away, weak, strong };
  /// How q1 grows along its direction, at a point.
  struct Uphill {
    bool is_known = false;
    double derivative = 0.0;
    glm::dvec3 step{
        0.0};  ///< The derivative times the direction: it points uphill whatever the latter's sign.
  };

  double weak_limit() const { return params_.limit * params_.weak_share; }

  /// Turned away from the eye or nearly so; q1 surely under the limit, since it is at most the curvature's
  /// size over the cosine; or not.
  Reach reach_at(uint32_t point) const {
    const glm::dvec3 to_eye = eye_.from(surface_.positions[point]);
    const double squared = glm::dot(to_eye, to_eye), along = glm::dot(to_eye, surface_.normals[point]);
    if (!(along > 0.0) || along * along <= kContourCosine * kContourCosine * squared) return Reach::away;
    const SymmetricTensor& t = surface_.curvature[point];
    const double bend =
        t[0] * t[0] + t[3] * t[3] + t[5] * t[5] + 2.0 * (t[1] * t[1] + t[2] * t[2] + t[4] * t[4]);
    return bend * squared < weak_limit() * weak_limit() * along * along ? Reach::weak : Reach::strong;
  }

  /// q1, worked out where somebody asks.
  double size(uint32_t point) {
    if (size_[point] == kUnknown) {
      const glm::dvec3 to_eye = eye_.from(surface_.positions[point]);
      const double distance = glm::length(to_eye);
      const glm::dvec3 view = distance > 0.0 ? to_eye / distance : surface_.normals[point];
      const ApparentCurvature apparent =
          apparent_curvature(surface_.curvature[point], surface_.normals[point], view);
      size_[point] = apparent.size;
      direction_[point] = apparent.direction;
    }
    return size_[point];
  }

  const Uphill& uphill(uint32_t point) {
    Uphill& uphill = uphill_[point];
    if (!uphill.is_known) {
      for (uint32_t i = surface_.face_starts[point]; i < surface_.face_starts[point + 1]; ++i) {
        for (const uint32_t around : surface_.faces[surface_.point_faces[i]]) size(around);
      }
      uphill.is_known = true;
      uphill.derivative = glm::dot(gradient_at_point(surface_, size_, point), direction_[point]);
      uphill.step = uphill.derivative * direction_[point];
    }
    return uphill;
  }

  bool can_have_line(const std::array<uint32_t, 3>& face) {
    const auto [a, b, c] = face;
    const Reach least = std::min({reach_[a], reach_[b], reach_[c]});
    if (least == Reach::away || std::max({reach_[a], reach_[b], reach_[c]}) == Reach::weak) return false;
    return std::max({size(a), size(b), size(c)}) >= weak_limit();
  }

  void add_face(uint32_t f) {
    const std::array<uint32_t, 3>& face = surface_.faces[f];
    if (!can_have_line(face)) return;
    std::array<LineTracer::Crossing, 3> found;
    size_t count = 0;
    for (size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      if (!(glm::dot(uphill(a).step, uphill(b).step) <= 0.0)) continue;
      const double size_a = std::abs(uphill(a).derivative), size_b = std::abs(uphill(b).derivative);
      const double share = size_a + size_b > 0.0 ? size_a / (size_a + size_b) : 0.5;
      found[count++] = {surface_.crossings[f][i],
                        glm::mix(surface_.positions[a], surface_.positions[b], share),
                        glm::mix(size_[a], size_[b], share) / params_.limit};
    }
    if (count == 2) add_step(f, found[0], found[1]);
    if (count == 3) {  // three lines meet in the middle
      const LineTracer::Crossing middle = LineTracer::middle(surface_.crossing_count + f, found);
      for (const LineTracer::Crossing& crossing : found) add_step(f, crossing, middle);
    }
  }

  void add_step(uint32_t f, const LineTracer::Crossing& a, const LineTracer::Crossing& b) {
    if (is_top(surface_.faces[f], a.point, b.point)) tracer_.add_step(f, a, b);
  }

  /// Is it uphill towards a line through a face, from both of its sides together?
  bool is_top(const std::array<uint32_t, 3>& face, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3& a = surface_.positions[face[0]];
    const glm::dvec3 normal = glm::cross(surface_.positions[face[1]] - a, surface_.positions[face[2]] - a);
    const glm::dvec3 across = glm::cross(normal, to - from);
    double towards = 0.0;
    for (const uint32_t point : face) {
      const double side = glm::dot(surface_.positions[point] - from, across);
      const double up = glm::dot(uphill(point).step, across);
      towards += side > 0.0 ? -up : up;
    }
    return towards > 0.0;
  }

  const SmoothSurface& surface_;
  const Viewpoint& eye_;
  ApparentRidgeParams params_;
  std::vector<Reach> reach_;
  std::vector<double> size_;
  std::vector<glm::dvec3> direction_;  ///< As `ApparentCurvature`, where the size is known.
  std::vector<Uphill> uphill_;
  LineTracer tracer_;
};

}  // namespace

ApparentCurvature apparent_curvature(const SymmetricTensor& curvature, const glm::dvec3& normal,
                                     const glm::dvec3& to_eye) {
  const double cosine = glm::dot(normal, to_eye);
  const glm::dvec3 along = to_eye - normal * cosine;
  const double length = glm::length(along);
  const glm::dvec3 u = length > 1e-9 ? along / length : perpendicular(normal);
  const glm::dvec3 v = glm::cross(normal, u);
  const double stretch = 1.0 / std::max(std::abs(cosine), kLeastCosine);
  const double uu = quadratic_form(curvature, u) * stretch;
  const double vv = quadratic_form(curvature, v);
  const double uv = (quadratic_form(curvature, u + v) - quadratic_form(curvature, u) - vv) / 2.0;
  // Q = (uu, uv; uv * stretch, vv); the largest eigenvalue of its transpose times itself and its vector.
  const double first = uu * uu + uv * stretch * uv * stretch, last = uv * uv + vv * vv;
  const double mixed = uu * uv + uv * stretch * vv;
  const double half = (first - last) / 2.0;
  const double spread = std::sqrt(half * half + mixed * mixed);
  const double along_u = half >= 0.0 ? half + spread : mixed, along_v = half >= 0.0 ? mixed : spread - half;
  const double norm = std::sqrt(along_u * along_u + along_v * along_v);
  const glm::dvec2 t = norm > 0.0 ? glm::dvec2(along_u, along_v) / norm : glm::dvec2(1.0, 0.0);
  return {std::sqrt((first + last) / 2.0 + spread), t.x * stretch * u + t.y * v};
}

std::vector<SurfaceLine> apparent_ridges(const SmoothSurface& surface, const Viewpoint& eye,
                                         const ApparentRidgeParams& params) {
  return ApparentRidgeFinder(surface, eye, params).find();
}

}  // namespace inkbench
