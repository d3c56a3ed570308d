// SPDX-License-Identifier: MIT
#include "tests/gl/cpu_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace inkbench::reference {
namespace {

using glm::dmat3;
using glm::dvec3;

/// A model's shape, and the affine map from shape to world space.
struct Body {
  Shape shape;
  dmat3 linear;
  dvec3 origin;
  int object_id;
  bool two_sided;
};

struct Hit {
  double along;  ///< In units of the ray.
  dvec3 normal;  ///< Shape space, not of unit length.
};

/// About x, then y, then z.
dmat3 rotation(const dvec3& degrees) {
  const dvec3 a = glm::radians(degrees);
  const dmat3 x(dvec3(1, 0, 0), dvec3(0, std::cos(a.x), std::sin(a.x)),
                dvec3(0, -std::sin(a.x), std::cos(a.x)));
  const dmat3 y(dvec3(std::cos(a.y), 0, -std::sin(a.y)), dvec3(0, 1, 0),
                dvec3(std::sin(a.y), 0, std::cos(a.y)));
  const dmat3 z(dvec3(std::cos(a.z), std::sin(a.z), 0), dvec3(-std::sin(a.z), std::cos(a.z), 0),
                dvec3(0, 0, 1));
  return z * y * x;
}

Body make_body(const ModelParams& model, int object_id) {
  const bool is_sphere = model.shape == Shape::sphere || model.shape == Shape::inside_out_sphere;
  const double longest = is_sphere ? 2.0 : 1.0;
  const double fit = model.size > 0.0F ? model.size / longest : 1.0;
  const dvec3 scale = dvec3(model.scale) * fit;
  const dmat3 linear =
      rotation(model.rotation) * dmat3(dvec3(scale.x, 0, 0), dvec3(0, scale.y, 0), dvec3(0, 0, scale.z));
  const double base = model.shape == Shape::plane ? 0.0 : -longest / 2.0;
  const dvec3 anchor(0.0, model.anchor == Anchor::base ? base : 0.0, 0.0);
  return {model.shape, linear, dvec3(model.position) - linear * anchor, object_id, model.two_sided};
}

using Hits = std::vector<Hit>;

Hits hit_sphere(const dvec3& from, const dvec3& ray, double sign) {
  const double a = glm::dot(ray, ray);
  const double b = glm::dot(from, ray);
  const double inside = b * b - a * (glm::dot(from, from) - 1.0);
  if (inside < 0.0) return {};
  Hits hits;
  for (const double root : {-std::sqrt(inside), std::sqrt(inside)}) {
    const double along = (-b + root) / a;
    hits.push_back({along, sign * (from + along * ray)});
  }
  return hits;
}

Hits hit_box(const dvec3& from, const dvec3& ray) {
  Hits hits;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      const double along = (side - from[axis]) / ray[axis];
      const dvec3 at = from + along * ray;
      const double u = std::abs(at[(axis + 1) % 3]);
      const double v = std::abs(at[(axis + 2) % 3]);
      if (!(u <= 0.5 && v <= 0.5)) continue;
      dvec3 normal(0.0);
      normal[axis] = 2.0 * side;
      hits.push_back({along, normal});
    }
  }
  return hits;
}

Hits hit_plane(const dvec3& from, const dvec3& ray) {
  const double along = -from.y / ray.y;
  const dvec3 at = from + along * ray;
  if (!(std::abs(at.x) <= 0.5 && std::abs(at.z) <= 0.5)) return {};
  return {{along, dvec3(0, 1, 0)}};
}

Hits hit_body(const Body& body, const dvec3& eye, const dvec3& ray) {
  const dmat3 to_shape = glm::inverse(body.linear);
  const dvec3 from = to_shape * (eye - body.origin);
  const dvec3 direction = to_shape * ray;
  switch (body.shape) {
    case Shape::sphere:
      return hit_sphere(from, direction, 1.0);
    case Shape::inside_out_sphere:
      return hit_sphere(from, direction, -1.0);
    case Shape::box:
      return hit_box(from, direction);
    case Shape::plane:
      return hit_plane(from, direction);
    default:
      return {};
  }
}

}  // namespace

namespace {

/// From the view axis to a pixel's centre, in the plane where the image is `height` high.
dvec3 across(const CameraParams& camera, glm::dvec2 centre, glm::dvec2 size_px, double height) {
  const dvec3 forward = glm::normalize(dvec3(camera.target) - dvec3(camera.eye));
  const dvec3 right = glm::normalize(glm::cross(forward, dvec3(camera.up)));
  const dvec3 up = glm::cross(right, forward);
  const double pixel = height / size_px.y;
  return right * ((centre.x - size_px.x / 2.0) * pixel) + up * ((size_px.y / 2.0 - centre.y) * pixel);
}

}  // namespace

glm::dvec3 pixel_ray(const CameraParams& camera, int x, int y, int width_px, int height_px) {
  const dvec3 forward = glm::normalize(dvec3(camera.target) - dvec3(camera.eye));
  if (camera.projection == CameraProjection::orthographic) return forward;
  const double height = 2.0 * std::tan(glm::radians(static_cast<double>(camera.fov)) / 2.0);
  return forward + across(camera, {x + 0.5, y + 0.5}, {width_px, height_px}, height);
}

glm::dvec3 pixel_eye(const CameraParams& camera, int x, int y, int width_px, int height_px) {
  if (camera.projection != CameraProjection::orthographic) return camera.eye;
  return dvec3(camera.eye) + across(camera, {x + 0.5, y + 0.5}, {width_px, height_px}, camera.view_height);
}

glm::dvec3 seen_at(const Settings& settings, const glm::dvec3& world) {
  const CameraParams& camera = settings.camera;
  const dvec3 forward = glm::normalize(dvec3(camera.target) - dvec3(camera.eye));
  const dvec3 right = glm::normalize(glm::cross(forward, dvec3(camera.up)));
  const dvec3 up = glm::cross(right, forward);
  const dvec3 from_eye = world - dvec3(camera.eye);
  const double distance = glm::dot(from_eye, forward);
  const double half_height = std::tan(glm::radians(static_cast<double>(camera.fov)) / 2.0);
  const double px = settings.image.height / (2.0 * half_height * distance);
  return {settings.image.width / 2.0 + px * glm::dot(from_eye, right),
          settings.image.height / 2.0 - px * glm::dot(from_eye, up), distance};
}

Surface cast_rays(const Settings& settings) {
  const int width = settings.image.width;
  const int height = settings.image.height;
  const CameraParams& camera = settings.camera;
  std::vector<Body> bodies;
  for (size_t i = 0; i < settings.models.size(); ++i) {
    if (settings.models[i].visible) bodies.push_back(make_body(settings.models[i], static_cast<int>(i) + 1));
  }
  Surface surface{Map(width, height, 3, 0.5), Map(width, height, 1, 1.0), Map(width, height, 1, 0.0)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const dvec3 ray = pixel_ray(camera, x, y, width, height);
      const dvec3 eye = pixel_eye(camera, x, y, width, height);
      double nearest = camera.far;
      for (const Body& body : bodies) {
        for (const Hit& hit : hit_body(body, eye, ray)) {
          if (hit.along < camera.near || hit.along >= nearest) continue;
          nearest = hit.along;
          dvec3 normal = glm::normalize(glm::transpose(glm::inverse(body.linear)) * hit.normal);
          if (body.two_sided && glm::dot(normal, ray) > 0.0) normal = -normal;
          for (int c = 0; c < 3; ++c) surface.normal.at(x, y, c) = 0.5 * normal[c] + 0.5;
          surface.depth.at(x, y) = nearest / camera.far;
          surface.object_id.at(x, y) = body.object_id;
        }
      }
    }
  }
  return surface;
}

ImageOf<uint8_t> outlines(const Surface& surface) {
  const int width = surface.depth.width_px;
  const int height = surface.depth.height_px;
  constexpr double kCrease = 0.2;  // of 0.5 N + 0.5: a turn of about 24 degrees from one pixel to the next
  ImageOf<uint8_t> mask(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
          bool differs = surface.object_id.at(u, v) != surface.object_id.at(x, y);
          for (int c = 0; c < 3; ++c)
            differs |= std::abs(surface.normal.at(u, v, c) - surface.normal.at(x, y, c)) > kCrease;
          if (differs) mask.at(x, y) = 1;
        }
      }
    }
  }
  return mask;
}

}  // namespace inkbench::reference
