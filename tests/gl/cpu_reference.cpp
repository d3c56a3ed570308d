// SPDX-License-Identifier: MIT
#include "tests/gl/cpu_reference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace inkbench::reference {
namespace {

/// Table 1 of the paper with the weights of 3.4.3.
struct Neighbour {
  int dx, dy;
  double weight;
};
constexpr std::array<Neighbour, 8> kNeighbours{
    {{-1, -1, 1}, {0, -1, 2}, {1, -1, 1}, {-1, 0, 2}, {1, 0, 2}, {-1, 1, 1}, {0, 1, 2}, {1, 1, 1}}};

double clamped_at(const Map& map, int x, int y, int channel) {
  return map.at(std::clamp(x, 0, map.width_px - 1), std::clamp(y, 0, map.height_px - 1), channel);
}

double gradient_at(const Map& map, int x, int y, int channel) {
  double sum = 0.0;
  for (const Neighbour& n : kNeighbours) {
    sum += n.weight * std::abs(clamped_at(map, x + n.dx, y + n.dy, channel) - map.at(x, y, channel));
  }
  return sum / 8.0;
}

double term(double range, double k) {
  return std::min(std::pow(range / k, 2.0), 1.0);
}

}  // namespace

Map to_map(const Image& image) {
  Map map(image.width_px, image.height_px, image.channels);
  std::copy(image.samples.begin(), image.samples.end(), map.samples.begin());
  return map;
}

Image to_image(const Map& map) {
  Image image(map.width_px, map.height_px, map.channels);
  std::transform(map.samples.begin(), map.samples.end(), image.samples.begin(),
                 [](double value) { return static_cast<float>(value); });
  return image;
}

Map gradient(const Map& map) {
  Map result(map.width_px, map.height_px, 1);
  for (int y = 0; y < map.height_px; ++y) {
    for (int x = 0; x < map.width_px; ++x) {
      for (int c = 0; c < map.channels; ++c) result.at(x, y) += gradient_at(map, x, y, c) / map.channels;
    }
  }
  return result;
}

Map range(const Map& gradient) {
  Map result(gradient.width_px, gradient.height_px, 1);
  for (int y = 0; y < gradient.height_px; ++y) {
    for (int x = 0; x < gradient.width_px; ++x) {
      double low = gradient.at(x, y);
      double high = low;
      for (const Neighbour& n : kNeighbours) {
        const double g = clamped_at(gradient, x + n.dx, y + n.dy, 0);
        low = std::min(low, g);
        high = std::max(high, g);
      }
      result.at(x, y) = high - low;
    }
  }
  return result;
}

Map term_sum(const Map& depth_range, const Map& normal_range, const CombineParams& params) {
  Map result(depth_range.width_px, depth_range.height_px, 1);
  for (size_t i = 0; i < result.samples.size(); ++i) {
    if (params.use_depth) result.samples[i] += term(depth_range.samples[i], params.k_depth);
    if (params.use_normal) result.samples[i] += term(normal_range.samples[i], params.k_normal);
  }
  return result;
}

Map combine(const Map& sum, const CombineParams& params) {
  Map result = sum;
  for (double& value : result.samples) value = value < params.threshold ? 0.0 : std::min(value, 1.0);
  return result;
}

Map ink(const Map& shaded, const Map& edges, const InkParams& params) {
  Map result = shaded;
  for (size_t i = 0; i < edges.samples.size(); ++i) {
    for (int c = 0; c < 3 && edges.samples[i] != 0.0; ++c) result.samples[i * 3 + c] = params.colour[c];
  }
  return result;
}

}  // namespace inkbench::reference
