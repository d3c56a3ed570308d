// SPDX-License-Identifier: MIT
#include "tests/gl/cpu_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/gl/cpu_rays.h"

namespace inkbench::reference {
namespace {

using glm::dvec3;

/// The first stop is no step: the ramp has its colour before it, too.
bool is_near_step(const Ramp& ramp, double t) {
  return std::any_of(ramp.stops.begin() + 1, ramp.stops.end(),
                     [&](const RampStop& stop) { return std::abs(t - stop.position) < 1.0 / 1024.0; });
}

/// A point of a surface, and what the eye and the lights need to know of it.
struct Point {
  dvec3 position, normal, to_eye;
  MaterialParams material;
};

struct Lit {
  dvec3 colour{0.0};
  bool at_step = false;
};

Lit light_up(const LightParams& light, const Point& point, const RampParams& ramps, bool use_ramps) {
  const dvec3 way =
      light.type == LightType::point ? dvec3(light.position) - point.position : dvec3(light.direction);
  const dvec3 l = glm::normalize(way);
  const dvec3 h = glm::normalize(l + point.to_eye);
  const double diffuse = std::max(glm::dot(l, point.normal), 0.0);
  const double specular = std::pow(std::max(glm::dot(h, point.normal), 0.0), point.material.exponent);
  const dvec3 diffuse_shade = use_ramps ? ramp_colour(ramps.diffuse, diffuse) : dvec3(diffuse);
  const dvec3 specular_shade = use_ramps ? ramp_colour(ramps.specular, specular) : dvec3(specular);
  const dvec3 colour(point.material.colour);
  Lit lit;
  lit.colour = dvec3(light.ambient) * (colour * static_cast<double>(point.material.ambient)) +
               diffuse_shade * dvec3(light.diffuse) * (colour * static_cast<double>(point.material.diffuse)) +
               specular_shade * dvec3(light.specular) * static_cast<double>(point.material.specular);
  lit.at_step = use_ramps && (is_near_step(ramps.diffuse, diffuse) || is_near_step(ramps.specular, specular));
  return lit;
}

}  // namespace

glm::dvec3 ramp_colour(const Ramp& ramp, double t) {
  dvec3 colour(ramp.stops.front().colour);
  for (size_t i = 0; i < ramp.stops.size(); ++i) {
    const RampStop& stop = ramp.stops[i];
    if (t < stop.position) break;
    colour = stop.colour;
    if (stop.stepped || i + 1 == ramp.stops.size()) continue;
    const RampStop& next = ramp.stops[i + 1];
    const double share = (t - stop.position) / (static_cast<double>(next.position) - stop.position);
    colour = glm::mix(dvec3(stop.colour), dvec3(next.colour), std::min(share, 1.0));
  }
  return colour;
}

Shading shade(const Settings& settings, const Map& normal, const Map& depth, const Map& object_id,
              bool use_ramps) {
  Shading result{Map(depth.width_px, depth.height_px, 3),
                 ImageOf<uint8_t>(depth.width_px, depth.height_px, 1)};
  for (int y = 0; y < depth.height_px; ++y) {
    for (int x = 0; x < depth.width_px; ++x) {
      const int id = static_cast<int>(object_id.at(x, y));
      dvec3 colour(settings.scene.background);
      if (id > 0) {
        const dvec3 ray = pixel_ray(settings.camera, x, y, depth.width_px, depth.height_px);
        const dvec3 eye = pixel_eye(settings.camera, x, y, depth.width_px, depth.height_px);
        const dvec3 encoded(normal.at(x, y, 0), normal.at(x, y, 1), normal.at(x, y, 2));
        const Point point{eye + ray * (depth.at(x, y) * settings.camera.far),
                          glm::normalize(2.0 * encoded - 1.0), -glm::normalize(ray),
                          settings.models[id - 1].material};
        colour = dvec3(settings.scene.ambient) * dvec3(point.material.colour) *
                 static_cast<double>(point.material.ambient);
        for (const LightParams& light : settings.lights) {
          const Lit lit = light_up(light, point, settings.ramp, use_ramps);
          colour += lit.colour;
          if (lit.at_step) result.at_step.at(x, y) = 1;
        }
      }
      for (int c = 0; c < 3; ++c) result.colour.at(x, y, c) = colour[c];
    }
  }
  return result;
}

}  // namespace inkbench::reference
