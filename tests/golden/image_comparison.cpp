// SPDX-License-Identifier: MIT
#include "tests/golden/image_comparison.h"

#include <algorithm>
#include <cstdlib>

namespace inkbench {
namespace {

/// Largest difference of two pixels' samples.
int pixel_difference(const Picture& a, int ax, int ay, const Picture& b, int bx, int by) {
  int largest = 0;
  for (int c = 0; c < 3; ++c)
    largest = std::max(largest, std::abs(int(a.at(ax, ay, c)) - int(b.at(bx, by, c))));
  return largest;
}

/// Difference of a's pixel to the nearest of b's 3 x 3 pixels around the same place.
int nearest_difference(const Picture& a, const Picture& b, int x, int y) {
  int nearest = 255;
  for (int by = std::max(y - 1, 0); by <= std::min(y + 1, b.height_px - 1); ++by) {
    for (int bx = std::max(x - 1, 0); bx <= std::min(x + 1, b.width_px - 1); ++bx) {
      nearest = std::min(nearest, pixel_difference(a, x, y, b, bx, by));
    }
  }
  return nearest;
}

}  // namespace

PictureDifference compare(const Picture& expected, const Picture& actual) {
  PictureDifference difference;
  difference.picture = Picture(expected.width_px, expected.height_px, 3);
  double sum = 0.0;
  for (int y = 0; y < expected.height_px; ++y) {
    for (int x = 0; x < expected.width_px; ++x) {
      const int unmatched =
          std::max(nearest_difference(expected, actual, x, y), nearest_difference(actual, expected, x, y));
      difference.largest = std::max(difference.largest, unmatched);
      for (int c = 0; c < 3; ++c) {
        const int d = std::abs(int(expected.at(x, y, c)) - int(actual.at(x, y, c)));
        sum += d;
        difference.picture.at(x, y, c) =
            static_cast<uint8_t>(std::min(4 * d + (unmatched > 0 && d > 0 ? 128 : 0), 255));
      }
    }
  }
  difference.mean = sum / static_cast<double>(expected.samples.size());
  return difference;
}

}  // namespace inkbench
