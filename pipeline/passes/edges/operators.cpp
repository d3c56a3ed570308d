// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/operators.h"

#include <algorithm>
#include <cmath>

namespace inkbench {
namespace {

/// Where the operator is taken along one side of the image.
int operator_centre(int at, int size) {
  const int low = std::min(1, (size - 1) / 2);
  return std::clamp(at, low, std::max(size - 2, low));
}

/// A pixel's neighbours by the letters of the paper's Table 1.
struct Letters {
  double a, b, c, d, x, e, f, g, h;
};

Letters letters_at(const Image& image, int x, int y, int channel) {
  const int cx = operator_centre(x, image.width_px), cy = operator_centre(y, image.height_px);
  const auto value = [&](int dx, int dy) -> double {
    return image.at(std::clamp(cx + dx, 0, image.width_px - 1), std::clamp(cy + dy, 0, image.height_px - 1),
                    channel);
  };
  return {value(-1, -1), value(0, -1), value(1, -1), value(-1, 0), value(0, 0),
          value(1, 0),   value(-1, 1), value(0, 1),  value(1, 1)};
}

}  // namespace

bool is_inside_image(const Image& image, int x, int y) {
  return x >= 0 && x < image.width_px && y >= 0 && y < image.height_px;
}

double first_order(const Image& image, int x, int y, int channel) {
  const Letters n = letters_at(image, x, y, channel);
  return (std::abs(n.a + 2 * n.b + n.c - n.f - 2 * n.g - n.h) +
          std::abs(n.c + 2 * n.e + n.h - n.a - 2 * n.d - n.f)) /
         8;
}

double second_order(const Image& image, int x, int y, int channel) {
  const Letters n = letters_at(image, x, y, channel);
  return std::abs(8 * n.x - (n.a + n.b + n.c + n.d + n.e + n.f + n.g + n.h)) / 3;
}

RangeAround range_of(const std::array<std::optional<float>, 9>& around) {
  RangeAround range{*around[4], *around[4], {}, {}};
  for (int i = 0; i < 9; ++i) {
    const std::optional<float>& value = around[static_cast<size_t>(i)];
    if (!value) continue;
    const Offset at{i % 3 - 1, i / 3 - 1};
    if (*value > range.largest) {
      range.largest = *value;
      range.largest_at = at;
    }
    if (*value < range.smallest) {
      range.smallest = *value;
      range.smallest_at = at;
    }
  }
  return range;
}

std::array<std::optional<float>, 9> values_around(const Image& image, int x, int y, int channel) {
  std::array<std::optional<float>, 9> values;
  for (int i = 0; i < 9; ++i) {
    const int nx = x + i % 3 - 1, ny = y + i / 3 - 1;
    if (is_inside_image(image, nx, ny)) values[static_cast<size_t>(i)] = image.at(nx, ny, channel);
  }
  return values;
}

}  // namespace inkbench
