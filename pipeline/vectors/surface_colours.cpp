// SPDX-License-Identifier: MIT
#include "pipeline/vectors/surface_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace inkbench {
namespace {

constexpr int kRings = 3;  ///< Around a place, each twice as far as the one before.
constexpr std::array<glm::vec2, 8> kWays{
    {{1, 0}, {0.7F, 0.7F}, {0, 1}, {-0.7F, 0.7F}, {-1, 0}, {-0.7F, -0.7F}, {0, -1}, {0.7F, -0.7F}}};

struct Place {
  int x = 0, y = 0;
  float weight = 1.0F;
};

std::array<Place, 1 + 8 * kRings> places_around(const glm::vec2& at, const SurfaceColours& surface) {
  std::array<Place, 1 + 8 * kRings> places;
  for (size_t i = 0; i < places.size(); ++i) {
    const auto ring = static_cast<float>(1 << ((i + 7) / 8));
    const float away = surface.reach_px * ring / static_cast<float>(1 << kRings);
    const glm::vec2 place = i == 0 ? at : at + away * kWays[(i - 1) % 8];
    const auto inside = [](float value, int size) {
      return std::clamp(static_cast<int>(std::floor(value)), 0, size - 1);
    };
    places[i] = {inside(place.x, surface.colours.width_px), inside(place.y, surface.colours.height_px),
                 1.0F / ring};
  }
  return places;
}

}  // namespace

glm::vec3 SurfaceColours::at(const glm::vec2& place) const {
  const auto places = places_around(place, *this);
  const auto depth_at = [&](const Place& at) { return depth.at(at.x, at.y, depth.channels - 1); };
  const Place nearest = *std::min_element(
      places.begin(), places.end(),
      [&](const Place& one, const Place& other) { return depth_at(one) < depth_at(other); });
  glm::vec3 sum(0.0F);
  float weights = 0.0F;
  for (const Place& at : places) {
    if (object_ids.at(at.x, at.y) != object_ids.at(nearest.x, nearest.y)) continue;
    sum += at.weight *
           glm::vec3(colours.at(at.x, at.y, 0), colours.at(at.x, at.y, 1), colours.at(at.x, at.y, 2));
    weights += at.weight;
  }
  return sum / weights;
}

}  // namespace inkbench
