// SPDX-License-Identifier: MIT
// What vectors are compared by: coverage of discs and of paths, each by looking at many places in a pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "pipeline/image/image.h"
#include "pipeline/strokes/stroke.h"
#include "pipeline/vectors/cubic_path.h"
#include "pipeline/vectors/outline.h"

namespace inkbench {

inline constexpr int kPlacesASide = 8;  ///< In a pixel.

/// Many places of an image, `kPlacesASide` a pixel in each direction: which are covered.
struct PlaceMap {
  int width, height;
  std::vector<char> covered;

  PlaceMap(int width_px, int height_px)
      : width(width_px * kPlacesASide),
        height(height_px * kPlacesASide),
        covered(static_cast<size_t>(width) * height, 0) {}

  static double px(int place) { return (place + 0.5) / kPlacesASide; }
  char& at(int x, int y) { return covered[static_cast<size_t>(y) * width + x]; }

  Image coverage() const {
    Image image(width / kPlacesASide, height / kPlacesASide, 1);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x)
        image.at(x / kPlacesASide, y / kPlacesASide) +=
            static_cast<float>(covered[static_cast<size_t>(y) * width + x]) / (kPlacesASide * kPlacesASide);
    }
    return image;
  }
};

/// Of the discs along the strokes, one after another.
inline Image disc_coverage(const std::vector<Stroke>& strokes, int width, int height) {
  PlaceMap map(width, height);
  const auto fill = [&](const glm::dvec2& centre, double radius) {
    const auto place = [](double at_px) { return static_cast<int>(std::floor(at_px * kPlacesASide)); };
    for (int y = std::max(0, place(centre.y - radius));
         y <= std::min(map.height - 1, place(centre.y + radius)); ++y) {
      for (int x = std::max(0, place(centre.x - radius));
           x <= std::min(map.width - 1, place(centre.x + radius)); ++x) {
        if (glm::distance(centre, glm::dvec2(PlaceMap::px(x), PlaceMap::px(y))) <= radius) map.at(x, y) = 1;
      }
    }
  };
  for (const Stroke& stroke : strokes) {
    for (size_t i = 1; i < stroke.points.size(); ++i) {
      const StrokePoint &from = stroke.points[i - 1], &to = stroke.points[i];
      const int discs = 1 + static_cast<int>(glm::distance(from.at, to.at) / 0.05F);
      for (int k = 0; k <= discs; ++k) {
        const double share = static_cast<double>(k) / discs;
        fill(glm::mix(glm::dvec2(from.at), glm::dvec2(to.at), share),
             glm::mix(static_cast<double>(from.radius_px), static_cast<double>(to.radius_px), share));
      }
    }
  }
  return map.coverage();
}

inline Ring flattened(const CubicPath& path) {
  Ring ring{path.start};
  for (size_t i = 0; i < path.pieces.size(); ++i) {
    const int steps = path.pieces[i].is_line ? 1 : 24;
    for (int step = 1; step <= steps; ++step)
      ring.push_back(path.cubic(i).at(static_cast<double>(step) / steps));
  }
  return ring;
}

/// Of what the rings go round, by the rule of non-zero winding.
inline Image ring_coverage(const std::vector<Ring>& rings, int width, int height) {
  PlaceMap map(width, height);
  for (int y = 0; y < map.height; ++y) {
    std::vector<std::pair<double, int>> crossings;
    for (const Ring& ring : rings) {
      for (size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
        const glm::dvec2 &from = ring[before], &to = ring[i];
        if ((from.y <= PlaceMap::px(y)) == (to.y <= PlaceMap::px(y))) continue;
        const double share = (PlaceMap::px(y) - from.y) / (to.y - from.y);
        crossings.emplace_back(glm::mix(from.x, to.x, share), to.y > from.y ? 1 : -1);
      }
    }
    std::sort(crossings.begin(), crossings.end());
    int winding = 0;
    size_t next = 0;
    for (int x = 0; x < map.width; ++x) {
      for (; next < crossings.size() && crossings[next].first <= PlaceMap::px(x); ++next)
        winding += crossings[next].second;
      map.at(x, y) = winding != 0;
    }
  }
  return map.coverage();
}

/// Root of the mean square difference over the pixels that either covers.
inline double coverage_rms(const Image& one, const Image& other) {
  double sum = 0.0, count = 0.0;
  for (size_t i = 0; i < one.samples.size(); ++i) {
    if (one.samples[i] == 0.0F && other.samples[i] == 0.0F) continue;
    sum += std::pow(one.samples[i] - other.samples[i], 2.0);
    count += 1.0;
  }
  return count == 0.0 ? 0.0 : std::sqrt(sum / count);
}

inline Stroke stroke_through(const std::vector<std::pair<glm::vec2, float>>& points_and_radii) {
  Stroke stroke;
  for (const auto& [at, radius] : points_and_radii) stroke.points.push_back({at, radius, stroke.end_px, {}});
  return stroke;
}

/// Round a point, with a width that swells and shrinks: its middle is a hole.
inline Stroke ring_stroke(const glm::vec2& centre, float radius) {
  Stroke stroke;
  for (int i = 0; i <= 64; ++i) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i % 64) / 64.0F;
    stroke.points.push_back({centre + radius * glm::vec2(std::cos(angle), std::sin(angle)),
                             2.0F + std::sin(3.0F * angle),
                             0.0F,
                             {}});
  }
  stroke.is_closed = true;
  return stroke;
}

/// A loop that crosses itself, thin at its ends.
inline Stroke loop_stroke() {
  Stroke stroke;
  for (int i = 0; i <= 100; ++i) {
    const float t = static_cast<float>(i) / 100.0F;
    const float angle = 8.0F * t;
    const glm::vec2 at(20.0F + 60.0F * t + 18.0F * std::sin(angle), 50.0F + 22.0F * std::cos(angle));
    stroke.points.push_back({at, 3.0F * std::sin(3.0F * t) + 0.05F, 0.0F, {}});
  }
  return stroke;
}

}  // namespace inkbench
