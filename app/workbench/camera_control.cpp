// SPDX-License-Identifier: MIT
#include "app/workbench/camera_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_double3x3.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <variant>

namespace inkbench {
namespace {

constexpr double kDollyStep = 0.9;
constexpr double kFitMargin = 1.05;

bool is_within(const Limits& limits, double value) {
  return value >= limits.low && value <= limits.high;  // false for NaN
}

/// `moved` if all its values are within their parameters' limits, else `before`.
CameraParams accepted_or(const CameraParams& moved, const CameraParams& before) {
  for (const Field& field : CameraParams::description().fields) {
    const Value value = field.get(&moved);
    if (const auto* number = std::get_if<float>(&value);
        number != nullptr && !is_within(field.limits, *number))
      return before;
    if (const auto* vector = std::get_if<glm::vec3>(&value)) {
      for (int i = 0; i < 3; ++i) {
        if (!is_within(field.limits, (*vector)[i])) return before;
      }
    }
  }
  return moved;
}

glm::dvec3 up_of(const CameraParams& camera) {
  const glm::dvec3 up(camera.up);
  return glm::length(up) > 1e-6 ? glm::normalize(up) : glm::dvec3(0, 1, 0);
}

/// Right-handed axes about which azimuth and elevation are measured: x right, y up, z to the front.
struct CameraFrame {
  glm::dvec3 right, up, front;
};

CameraFrame frame_of(const CameraParams& camera) {
  const glm::dvec3 up = up_of(camera);
  const glm::dvec3 reference = std::abs(up.z) < 0.999 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 front = glm::normalize(reference - up * glm::dot(reference, up));
  return {glm::cross(up, front), up, front};
}

struct Angles {
  double azimuth = 0, elevation = 0;  ///< In radians.
};

Angles angles_of(const CameraFrame& frame, const glm::dvec3& direction) {
  const double level = std::hypot(glm::dot(direction, frame.right), glm::dot(direction, frame.front));
  return {std::atan2(glm::dot(direction, frame.right), glm::dot(direction, frame.front)),
          std::atan2(glm::dot(direction, frame.up), level)};
}

glm::dvec3 direction_at(const CameraFrame& frame, const Angles& angles) {
  const double limit = glm::radians(kMaxElevationDeg);
  const double elevation = std::clamp(angles.elevation, -limit, limit);
  return std::cos(elevation) *
             (std::sin(angles.azimuth) * frame.right + std::cos(angles.azimuth) * frame.front) +
         std::sin(elevation) * frame.up;
}

glm::dvec3 offset_of(const CameraParams& camera) {
  return glm::dvec3(camera.eye) - glm::dvec3(camera.target);
}

/// The camera's own axes: right and up in the image plane, back towards the viewer.
struct ViewAxes {
  glm::dvec3 right, up, back;
  double distance = 0;  ///< Of the target.
};

ViewAxes view_axes(const CameraParams& camera) {
  ViewAxes axes;
  axes.distance = glm::length(offset_of(camera));
  axes.back = offset_of(camera) / std::max(axes.distance, 1e-12);
  glm::dvec3 right = glm::cross(up_of(camera), axes.back);
  if (glm::length(right) < 1e-9) right = frame_of(camera).right;
  axes.right = glm::normalize(right);
  axes.up = glm::cross(axes.back, axes.right);
  return axes;
}

/// World units for each px in the plane through the target.
double units_per_px(const CameraParams& camera, double distance, const ViewSize& size) {
  return seen_height(camera, distance) / std::max(size.height_px, 1.0F);
}

/// Of an orthographic view: scales what is seen about a point in the plane through the target.
CameraParams zoomed_about(const CameraParams& camera, const glm::dvec3& point, double steps) {
  const double factor = std::pow(kDollyStep, steps);
  const glm::dvec3 shift = (point - glm::dvec3(camera.target)) * (1.0 - factor);
  CameraParams moved = camera;
  moved.view_height = static_cast<float>(camera.view_height * factor);
  moved.eye = glm::vec3(glm::dvec3(camera.eye) + shift);
  moved.target = glm::vec3(glm::dvec3(camera.target) + shift);
  return accepted_or(moved, camera);
}

/// Scales eye and target about a point in the plane through the target, which keeps it under the same pixel.
CameraParams scaled_about(const CameraParams& camera, const glm::dvec3& point, double steps) {
  if (is_orthographic(camera)) return zoomed_about(camera, point, steps);
  const double distance = glm::length(offset_of(camera));
  // A camera that is outside the range already may stay there but not go further.
  const double low = std::min(2.0 * camera.near, distance);
  const double high = std::max(0.95 * camera.far, distance);
  const double factor = std::clamp(distance * std::pow(kDollyStep, steps), low, high) / distance;
  CameraParams moved = camera;
  moved.eye = glm::vec3(point + (glm::dvec3(camera.eye) - point) * factor);
  moved.target = glm::vec3(point + (glm::dvec3(camera.target) - point) * factor);
  return accepted_or(moved, camera);
}

std::array<glm::dvec3, 8> corners_of(const Bounds& bounds) {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    corners[static_cast<size_t>(i)] = {(i & 1) != 0 ? bounds.high.x : bounds.low.x,
                                       (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                                       (i & 4) != 0 ? bounds.high.z : bounds.low.z};
  }
  return corners;
}

/// Up (or down) to two digits, so that parameters stay readable.
float rounded_up(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return static_cast<float>(std::ceil(value / unit) * unit);
}
float rounded_down(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return static_cast<float>(std::floor(value / unit) * unit);
}

/// The cursor on the trackball, in the camera's axes.
glm::dvec3 on_ball(const glm::vec2& cursor_px, const ViewSize& size) {
  const double radius = std::max(1.0F, std::min(size.width_px, size.height_px) / 2);
  const double x = (cursor_px.x - size.width_px / 2) / radius;
  const double y = (size.height_px / 2 - cursor_px.y) / radius;
  const double square = x * x + y * y;
  const double z = square < 0.5 ? std::sqrt(1 - square) : 0.5 / std::sqrt(square);
  return glm::normalize(glm::dvec3(x, y, z));
}

/// `v` turned by the shortest rotation that takes `from` to `to` (Rodrigues' formula); all of unit length.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 axis = glm::cross(from, to);
  const double sine = glm::length(axis);
  if (sine < 1e-12) return v;
  const double cosine = glm::dot(from, to);
  const glm::dvec3 unit = axis / sine;
  return v * cosine + glm::cross(unit, v) * sine + unit * glm::dot(unit, v) * (1 - cosine);
}

}  // namespace

CameraParams orbit(const CameraParams& camera, double yaw_deg, double pitch_deg) {
  const Angles now = angles_of(frame_of(camera), offset_of(camera));
  return view_from(camera, glm::degrees(now.azimuth) + yaw_deg, glm::degrees(now.elevation) + pitch_deg);
}

CameraParams orbit_drag(const CameraParams& camera, const glm::vec2& from_px, const glm::vec2& to_px,
                        const ViewSize& size) {
  const double degrees_per_px = 180.0 / std::max(size.height_px, 1.0F);
  return orbit(camera, (from_px.x - to_px.x) * degrees_per_px, (to_px.y - from_px.y) * degrees_per_px);
}

CameraParams view_from(const CameraParams& camera, double azimuth_deg, double elevation_deg) {
  const CameraFrame frame = frame_of(camera);
  const glm::dvec3 direction = direction_at(frame, {glm::radians(azimuth_deg), glm::radians(elevation_deg)});
  CameraParams moved = camera;
  moved.eye = glm::vec3(glm::dvec3(camera.target) + direction * glm::length(offset_of(camera)));
  return accepted_or(moved, camera);
}

CameraParams pan(const CameraParams& camera, const glm::vec2& from_px, const glm::vec2& to_px,
                 const ViewSize& size) {
  const ViewAxes axes = view_axes(camera);
  const double units = units_per_px(camera, axes.distance, size);
  const glm::dvec3 drag =
      axes.right * (double{to_px.x} - from_px.x) * units - axes.up * (double{to_px.y} - from_px.y) * units;
  CameraParams moved = camera;
  moved.eye = glm::vec3(glm::dvec3(camera.eye) - drag);
  moved.target = glm::vec3(glm::dvec3(camera.target) - drag);
  return accepted_or(moved, camera);
}

CameraParams dolly(const CameraParams& camera, double steps) {
  return scaled_about(camera, glm::dvec3(camera.target), steps);
}

CameraParams dolly_at(const CameraParams& camera, double steps, const glm::vec2& cursor_px,
                      const ViewSize& size) {
  const ViewAxes axes = view_axes(camera);
  const double units = units_per_px(camera, axes.distance, size);
  const glm::dvec3 under_cursor = glm::dvec3(camera.target) +
                                  axes.right * (double{cursor_px.x} - size.width_px / 2) * units +
                                  axes.up * (size.height_px / 2 - double{cursor_px.y}) * units;
  return scaled_about(camera, under_cursor, steps);
}

CameraParams look_around(const CameraParams& camera, double yaw_deg, double pitch_deg) {
  const CameraFrame frame = frame_of(camera);
  const glm::dvec3 forward = -offset_of(camera);
  Angles angles = angles_of(frame, forward);
  angles.azimuth -= glm::radians(yaw_deg);
  angles.elevation += glm::radians(pitch_deg);
  CameraParams moved = camera;
  moved.target = glm::vec3(glm::dvec3(camera.eye) + direction_at(frame, angles) * glm::length(forward));
  return accepted_or(moved, camera);
}

CameraParams with_projection(const CameraParams& camera, CameraProjection projection) {
  if (projection == camera.projection) return camera;
  const ViewAxes axes = view_axes(camera);
  CameraParams moved = camera;
  moved.projection = projection;
  if (is_orthographic(moved)) {
    moved.view_height = static_cast<float>(seen_height(camera, axes.distance));
    return accepted_or(moved, camera);
  }
  const double distance = camera.view_height / seen_height(moved, 1.0);
  moved.eye = glm::vec3(glm::dvec3(camera.target) + axes.back * distance);
  if (distance > 0.95 * camera.far) moved.far = rounded_up(distance / 0.95);
  if (distance < 2.0 * camera.near) moved.near = rounded_down(distance / 2.0);
  return accepted_or(moved, camera);
}

CameraParams fit_to_bounds(const CameraParams& camera, const Bounds& bounds, const ViewSize& size) {
  const bool is_empty = bounds.low == bounds.high;
  const Bounds box = is_empty ? Bounds{bounds.low - 0.5F, bounds.high + 0.5F} : bounds;
  const glm::dvec3 middle = (glm::dvec3(box.low) + glm::dvec3(box.high)) / 2.0;
  const double aspect = size.width_px / std::max(size.height_px, 1.0F);
  const ViewAxes axes = view_axes(camera);
  const bool orthographic = is_orthographic(camera);
  double distance = orthographic ? glm::length(glm::dvec3(box.high) - glm::dvec3(box.low)) : 0.0;
  double height = 0;
  for (const glm::dvec3& corner : corners_of(box)) {
    const glm::dvec3 arm = corner - middle;
    const double needed =
        2.0 * kFitMargin *
        std::max(std::abs(glm::dot(arm, axes.right)) / aspect, std::abs(glm::dot(arm, axes.up)));
    height = std::max(height, needed);
    if (!orthographic)
      distance = std::max(distance, glm::dot(arm, axes.back) + needed / seen_height(camera, 1.0));
  }
  CameraParams moved = camera;
  if (orthographic) moved.view_height = static_cast<float>(height);
  moved.target = glm::vec3(middle);
  moved.eye = glm::vec3(middle + axes.back * distance);
  return accepted_or(keep_in_range(moved, bounds), camera);
}

CameraParams keep_in_range(const CameraParams& camera, const Bounds& bounds) {
  const glm::dvec3 back = view_axes(camera).back;
  double nearest = INFINITY;
  double farthest = -INFINITY;
  for (const glm::dvec3& corner : corners_of(bounds)) {
    const double depth = glm::dot(glm::dvec3(camera.eye) - corner, back);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  CameraParams moved = camera;
  if (is_orthographic(camera) && nearest <= camera.near) {
    const double step = 2.0 * camera.near - nearest;
    moved.eye = glm::vec3(glm::dvec3(camera.eye) + back * step);
    nearest += step;
    farthest += step;
  }
  if (farthest >= camera.far) moved.far = rounded_up(1.1 * farthest);
  if (nearest > 0 && nearest <= camera.near) moved.near = rounded_down(0.5 * nearest);
  // An eye inside the box sees what is at hand; near is then just not larger than makes sense for far.
  if (nearest <= 0) moved.near = std::min(camera.near, moved.far / 100);
  return accepted_or(moved, camera);
}

glm::vec3 drag_light(const glm::vec3& direction, const CameraParams& camera, const glm::vec2& from_px,
                     const glm::vec2& to_px, const ViewSize& size) {
  const ViewAxes axes = view_axes(camera);
  const glm::dmat3 to_world(axes.right, axes.up, axes.back);
  const glm::dvec3 given(direction);
  const glm::dvec3 unit = glm::length(given) > 1e-9 ? glm::normalize(given) : axes.back;
  const glm::dvec3 moved = turned(unit, to_world * on_ball(from_px, size), to_world * on_ball(to_px, size));
  return glm::clamp(glm::vec3(glm::normalize(moved)), glm::vec3(-1.0F), glm::vec3(1.0F));
}

}  // namespace inkbench
