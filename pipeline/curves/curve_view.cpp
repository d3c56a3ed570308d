// SPDX-License-Identifier: MIT
#include "pipeline/curves/curve_view.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace inkbench {

CurveView::CurveView(const CameraParams& camera, int width_px, int height_px)
    : projection_(projection_matrix(camera, static_cast<float>(width_px) / static_cast<float>(height_px))),
      eye_(camera.eye),
      target_(camera.target),
      near_(camera.near),
      far_(camera.far),
      half_height_(1.0 / projection_[1][1]),
      width_px_(width_px),
      height_px_(height_px),
      is_orthographic_(is_orthographic(camera)) {
  const glm::dmat4 view(view_matrix(camera));
  to_clip_ = projection_ * view;
  right_ = {view[0][0], view[1][0], view[2][0]};
  up_ = {view[0][1], view[1][1], view[2][1]};
  forward_ = -glm::dvec3(view[0][2], view[1][2], view[2][2]);
}

glm::dvec3 CurveView::to_pixel(const glm::dvec4& clip) const {
  const double nearness = is_orthographic_ ? (clip.z - projection_[3][2]) / projection_[2][2] : 1.0 / clip.w;
  return {(0.5 + 0.5 * clip.x / clip.w) * width_px_, (0.5 - 0.5 * clip.y / clip.w) * height_px_, nearness};
}

Viewpoint CurveView::viewpoint() const {
  return is_orthographic_ ? Viewpoint::at_infinity(eye_ - target_) : Viewpoint(eye_);
}

Ray CurveView::ray_to(const glm::dvec3& world) const {
  const double z = glm::dot(world - eye_, forward_);
  const glm::dvec3 origin = is_orthographic_ ? world - z * forward_ : eye_;
  return {origin, world - origin, near_ / z, 1.0};
}

Ray CurveView::ray_through(const glm::dvec2& pixel, double nearness) const {
  const double z = distance(nearness);
  const double aspect = static_cast<double>(width_px_) / height_px_;
  const double x = (2.0 * pixel.x / width_px_ - 1.0) * half_height_ * aspect;
  const double y = (1.0 - 2.0 * pixel.y / height_px_) * half_height_;
  const glm::dvec3 aside = x * right_ + y * up_;
  if (is_orthographic_) return {eye_ + aside, z * forward_, near_ / z, far_ / z};
  return {eye_, z * (forward_ + aside), near_ / z, far_ / z};
}

}  // namespace inkbench
