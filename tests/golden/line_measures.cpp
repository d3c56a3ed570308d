// SPDX-License-Identifier: MIT
#include "tests/golden/line_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace inkbench {
namespace {

struct Place {
  int x, y;
};

// The four direct neighbours first, then the diagonal ones.
constexpr std::array<Place, 8> kNeighbours{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};

bool is_in(const Mask& mask, int x, int y) {
  return x >= 0 && y >= 0 && x < mask.width_px && y < mask.height_px && mask.at(x, y) != 0;
}

bool is_inside_picture(const Mask& mask, Place p) {
  return p.x >= 0 && p.y >= 0 && p.x < mask.width_px && p.y < mask.height_px;
}

template <class Function>
Mask map_pixels(int width, int height, const Function& function) {
  Mask mask(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) mask.at(x, y) = function(x, y) ? 1 : 0;
  }
  return mask;
}

/// Length in px of the mask's run through a pixel along a direction.
double run_length(const Mask& mask, int x, int y, Place direction) {
  int steps = 1;
  for (const int sign : {1, -1}) {
    for (int i = 1; is_in(mask, x + sign * i * direction.x, y + sign * i * direction.y); ++i) ++steps;
  }
  return steps * std::hypot(direction.x, direction.y);
}

}  // namespace

Mask ink_of(const Image& combined_edges) {
  return map_pixels(combined_edges.width_px, combined_edges.height_px,
                    [&](int x, int y) { return combined_edges.at(x, y) > 0.0F; });
}

Mask pixels_of_object(const Image& object_id, float id) {
  return map_pixels(object_id.width_px, object_id.height_px,
                    [&](int x, int y) { return object_id.at(x, y) == id; });
}

Mask border_of(const Mask& mask) {
  return map_pixels(mask.width_px, mask.height_px, [&](int x, int y) {
    const auto outside = [&](int i) {
      const Place p{x + kNeighbours[i].x, y + kNeighbours[i].y};
      return is_inside_picture(mask, p) && mask.at(p.x, p.y) == 0;
    };
    return mask.at(x, y) != 0 && (outside(0) || outside(1) || outside(2) || outside(3));
  });
}

size_t count(const Mask& mask) {
  return mask.samples.size() -
         static_cast<size_t>(std::count(mask.samples.begin(), mask.samples.end(), uint8_t{0}));
}

Mask both(const Mask& a, const Mask& b) {
  return map_pixels(a.width_px, a.height_px,
                    [&](int x, int y) { return a.at(x, y) != 0 && b.at(x, y) != 0; });
}

Mask without(const Mask& a, const Mask& b) {
  return map_pixels(a.width_px, a.height_px,
                    [&](int x, int y) { return a.at(x, y) != 0 && b.at(x, y) == 0; });
}

ImageOf<int> depth_inside(const Mask& mask) {
  // Layer by layer from the outside: each step of 8 neighbours is one pixel of Chebyshev distance.
  ImageOf<int> depth(mask.width_px, mask.height_px, 1);
  std::vector<Place> layer;
  for (int y = 0; y < mask.height_px; ++y) {
    for (int x = 0; x < mask.width_px; ++x) {
      if (mask.at(x, y) == 0) layer.push_back({x, y});
    }
  }
  for (int distance = 1; !layer.empty(); ++distance) {
    std::vector<Place> next;
    for (const Place p : layer) {
      for (const Place step : kNeighbours) {
        const Place q{p.x + step.x, p.y + step.y};
        if (!is_inside_picture(mask, q) || mask.at(q.x, q.y) == 0 || depth.at(q.x, q.y) != 0) continue;
        depth.at(q.x, q.y) = distance;
        next.push_back(q);
      }
    }
    layer = std::move(next);
  }
  return depth;
}

Mask at_least_deep(const ImageOf<int>& depth, int px) {
  return map_pixels(depth.width_px, depth.height_px, [&](int x, int y) { return depth.at(x, y) >= px; });
}

Mask flood(const Mask& start, const Mask& free, int neighbours) {
  Mask reached = both(start, free);
  std::vector<Place> open;
  for (int y = 0; y < reached.height_px; ++y) {
    for (int x = 0; x < reached.width_px; ++x) {
      if (reached.at(x, y) != 0) open.push_back({x, y});
    }
  }
  while (!open.empty()) {
    const Place p = open.back();
    open.pop_back();
    for (int i = 0; i < neighbours; ++i) {
      const Place q{p.x + kNeighbours[i].x, p.y + kNeighbours[i].y};
      if (!is_in(free, q.x, q.y) || reached.at(q.x, q.y) != 0) continue;
      reached.at(q.x, q.y) = 1;
      open.push_back(q);
    }
  }
  return reached;
}

int pieces(const Mask& mask) {
  Mask rest = mask;
  int number = 0;
  for (int y = 0; y < mask.height_px; ++y) {
    for (int x = 0; x < mask.width_px; ++x) {
      if (rest.at(x, y) == 0) continue;
      ++number;
      std::vector<Place> open{{x, y}};
      rest.at(x, y) = 0;
      while (!open.empty()) {
        const Place p = open.back();
        open.pop_back();
        for (const Place step : kNeighbours) {
          if (!is_in(rest, p.x + step.x, p.y + step.y)) continue;
          rest.at(p.x + step.x, p.y + step.y) = 0;
          open.push_back({p.x + step.x, p.y + step.y});
        }
      }
    }
  }
  return number;
}

double inked_share(const Mask& ink, glm::vec2 from_px, glm::vec2 to_px) {
  const int steps = static_cast<int>(std::ceil(glm::distance(from_px, to_px)));
  int inked = 0;
  for (int i = 0; i <= steps; ++i) {
    const glm::vec2 at = glm::mix(from_px, to_px, static_cast<float>(i) / static_cast<float>(steps));
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    bool found = is_in(ink, x, y);
    for (const Place step : kNeighbours) found = found || is_in(ink, x + step.x, y + step.y);
    inked += found ? 1 : 0;
  }
  return static_cast<double>(inked) / (steps + 1);
}

Thickness thickness_at(const Mask& ink, const Mask& places) {
  std::vector<double> lengths;
  for (int y = 0; y < ink.height_px; ++y) {
    for (int x = 0; x < ink.width_px; ++x) {
      if (places.at(x, y) == 0 || ink.at(x, y) == 0) continue;
      double shortest_run = 1e9;
      for (const int i : {0, 2, 4, 6})
        shortest_run = std::min(shortest_run, run_length(ink, x, y, kNeighbours[i]));
      lengths.push_back(shortest_run);
    }
  }
  double sum = 0.0;
  double squares = 0.0;
  for (const double length : lengths) sum += length;
  const double mean = lengths.empty() ? 0.0 : sum / static_cast<double>(lengths.size());
  for (const double length : lengths) squares += (length - mean) * (length - mean);
  if (lengths.empty()) return {};
  return {mean, std::sqrt(squares / static_cast<double>(lengths.size())) / mean};
}

}  // namespace inkbench
