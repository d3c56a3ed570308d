// SPDX-License-Identifier: MIT
#include "pipeline/lines/projection.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace inkbench {
namespace {

/// Signed distances to the six planes of the view, positive inside.
std::array<double, 6> margins(const glm::dvec4& clip) {
  return {clip.w + clip.x, clip.w - clip.x, clip.w + clip.y,
          clip.w - clip.y, clip.w + clip.z, clip.w - clip.z};
}

/// The part of a step inside the view, as shares of its length; empty if from > to.
struct Inside {
  double from = 0.0, to = 1.0;
};

Inside clip_step(const glm::dvec4& a, const glm::dvec4& b) {
  const std::array<double, 6> at_a = margins(a);
  const std::array<double, 6> at_b = margins(b);
  Inside inside;
  for (size_t i = 0; i < at_a.size(); ++i) {
    if (at_a[i] < 0.0 && at_b[i] < 0.0) return {1.0, 0.0};
    if (at_a[i] < 0.0) inside.from = std::max(inside.from, at_a[i] / (at_a[i] - at_b[i]));
    if (at_b[i] < 0.0) inside.to = std::min(inside.to, at_a[i] / (at_a[i] - at_b[i]));
  }
  return inside;
}

Viewpoint viewpoint_of(const CameraParams& camera, const glm::dmat4& to_world) {
  const glm::dvec3 eye(camera.eye);
  const glm::dmat4 to_mesh = glm::inverse(to_world);
  if (!is_orthographic(camera)) return glm::dvec3(to_mesh * glm::dvec4(eye, 1.0));
  return Viewpoint::at_infinity(glm::dmat3(to_mesh) * (eye - glm::dvec3(camera.target)));
}

}  // namespace

Projection::Projection(const CameraParams& camera, int width_px, int height_px,
                       const glm::mat4& model_to_world)
    : width_px_(width_px),
      height_px_(height_px),
      projection_(projection_matrix(camera, static_cast<float>(width_px) / static_cast<float>(height_px))),
      to_clip_(projection_ * glm::dmat4(view_matrix(camera)) * glm::dmat4(model_to_world)),
      is_orthographic_(is_orthographic(camera)),
      viewpoint_(viewpoint_of(camera, model_to_world)),
      mirrored_(glm::determinant(glm::dmat3(model_to_world)) < 0.0) {}

glm::dvec3 Projection::to_pixel(const glm::dvec4& clip) const {
  const double depth = is_orthographic_ ? (projection_[3][2] - clip.z) / projection_[2][2] : 1.0 / clip.w;
  return {std::clamp((0.5 + 0.5 * clip.x / clip.w) * width_px_, 0.0, width_px_),
          std::clamp((0.5 - 0.5 * clip.y / clip.w) * height_px_, 0.0, height_px_), depth};
}

std::vector<ProjectedLine> Projection::project(std::span<const glm::dvec3> points) const {
  std::vector<ProjectedLine> lines;
  const bool closed = points.size() > 2 && points.front() == points.back();
  bool open_end = false;  // the last line ends inside the view, and the next step goes on from there
  bool starts_inside = false;
  glm::dvec4 from = to_clip_ * glm::dvec4(points[0], 1.0);
  for (size_t i = 1; i < points.size(); ++i) {
    const glm::dvec4 to = to_clip_ * glm::dvec4(points[i], 1.0);
    const Inside inside = clip_step(from, to);
    if (inside.from <= inside.to) {
      if (i == 1) starts_inside = inside.from == 0.0;
      if (!open_end || inside.from > 0.0) lines.push_back({to_pixel(glm::mix(from, to, inside.from))});
      lines.back().push_back(to_pixel(glm::mix(from, to, inside.to)));
    }
    open_end = inside.from <= inside.to && inside.to == 1.0;
    from = to;
  }
  if (closed && starts_inside && open_end && lines.size() > 1) {
    ProjectedLine& last = lines.back();
    last.insert(last.end(), lines.front().begin() + 1, lines.front().end());
    lines.front() = std::move(last);
    lines.pop_back();
  }
  return lines;
}

}  // namespace inkbench
