// SPDX-License-Identifier: MIT
// How far traced curves and the lines that they were traced from lie apart.
#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "pipeline/curves/curve.h"
#include "pipeline/curves/pixel_graph.h"

namespace inkbench {

using Segments = std::vector<std::pair<glm::vec2, glm::vec2>>;

inline Segments segments_of(const Curves& curves) {
  Segments segments;
  for (const Curve& curve : curves.curves) {
    for (size_t i = 1; i < curve.points.size(); ++i)
      segments.emplace_back(curve.points[i - 1], curve.points[i]);
  }
  return segments;
}

/// The thinned lines: from pixel centre to pixel centre.
inline Segments segments_of(const LinePixels& lines) {
  const PixelGraph graph(lines);
  Segments segments;
  for (uint32_t i = 0; i < lines.pixels.size(); ++i) {
    segments.emplace_back(lines.pixels[i].centre(), lines.pixels[i].centre());
    for (const uint32_t other : graph.links_of(i))
      segments.emplace_back(lines.pixels[i].centre(), lines.pixels[other].centre());
  }
  return segments;
}

inline float distance_to(const std::pair<glm::vec2, glm::vec2>& segment, const glm::vec2& point) {
  const glm::vec2 along = segment.second - segment.first;
  const float squared = glm::dot(along, along);
  const float share =
      squared > 0.0F ? std::clamp(glm::dot(point - segment.first, along) / squared, 0.0F, 1.0F) : 0.0F;
  return glm::distance(point, segment.first + share * along);
}

/// How far the first lines are at most from the second ones, seen at six steps of each segment.
inline float farthest(const Segments& from, const Segments& to) {
  float most = 0.0F;
  for (const auto& segment : from) {
    for (int step = 0; step <= 6; ++step) {
      const glm::vec2 point = glm::mix(segment.first, segment.second, static_cast<float>(step) / 6.0F);
      float least = 1e9F;
      for (const auto& other : to) least = std::min(least, distance_to(other, point));
      most = std::max(most, least);
    }
  }
  return most;
}

}  // namespace inkbench
