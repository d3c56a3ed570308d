// SPDX-License-Identifier: MIT
// The camera as curves see it, in double precision: from the world to pixels and back along rays. In: camera
// and image size. Out: clip space, pixel space, rays to points of the world.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "pipeline/curves/triangle_tree.h"
#include "pipeline/lines/viewpoint.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

class CurveView {
 public:
  CurveView(const CameraParams& camera, int width_px, int height_px);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  glm::dvec4 to_clip(const glm::dvec3& world) const { return to_clip_ * glm::dvec4(world, 1.0); }
  /// x and y as `Curve::points`, and what grows evenly towards the eye along projected straight lines: 1 / z,
  /// in orthographic views -z, z the distance along the view axis.
  glm::dvec3 to_pixel(const glm::dvec4& clip) const;
  /// z of such a third coordinate.
  double distance(double nearness) const { return is_orthographic_ ? -nearness : 1.0 / nearness; }

  Viewpoint viewpoint() const;
  /// From the near plane to the point, where t is 1.
  Ray ray_to(const glm::dvec3& world) const;
  /// Through a place in pixels, to the far plane; at `nearness` t is 1.
  Ray ray_through(const glm::dvec2& pixel, double nearness) const;

 private:
  glm::dmat4 to_clip_, projection_;
  glm::dvec3 eye_, target_, forward_, right_, up_;
  double near_, far_, half_height_;  ///< Half the seen height at distance 1, or at any in orthographic views.
  int width_px_, height_px_;
  bool is_orthographic_;
};

}  // namespace inkbench
