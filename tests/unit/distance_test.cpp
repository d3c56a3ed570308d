// SPDX-License-Identifier: MIT
// Distances against comparing every pixel with every other.
#include "studies/measures/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/line_map_support.h"

namespace inkbench {
namespace {

int64_t brute_force(int x, int y, const LineMap& to, bool wanted) {
  int64_t best = kInfinitelyFar;
  for (int ty = 0; ty < to.height_px(); ++ty) {
    for (int tx = 0; tx < to.width_px(); ++tx) {
      if (to.at(tx, ty) != wanted) continue;
      best = std::min(best, int64_t{tx - x} * (tx - x) + int64_t{ty - y} * (ty - y));
    }
  }
  return best;
}

void expect_exact(const LineMap& from, const LineMap& to) {
  const std::vector<Pixel> pixels = pixels_of(from);
  const std::vector<int64_t> distances = squared_distances(pixels, to);
  ASSERT_EQ(distances.size(), pixels.size());
  for (size_t i = 0; i < pixels.size(); ++i) {
    ASSERT_EQ(distances[i], brute_force(pixels[i].x, pixels[i].y, to, true))
        << pixels[i].x << ' ' << pixels[i].y;
  }
}

TEST(Distance, is_exact_for_few_and_for_many_pixels_a_row) {
  const double from_densities[] = {0.02, 0.9};               // walks along the row; takes the envelope
  const double to_densities[] = {0.0003, 0.002, 0.02, 0.3};  // mostly far to always near
  uint32_t seed = 0;
  for (const double from_density : from_densities) {
    for (const double to_density : to_densities) {
      for (const int width : {40, 64, 131}) {
        ++seed;
        expect_exact(random_map(width, 50, from_density, seed),
                     random_map(width, 50, to_density, seed + 1000));
      }
    }
  }
}

TEST(Distance, is_exact_to_single_pixels_anywhere) {
  const LineMap all = random_map(37, 29, 1, 0);
  for (const Pixel target : {Pixel{0, 0}, Pixel{36, 28}, Pixel{36, 0}, Pixel{0, 28}, Pixel{18, 14}}) {
    LineMap to(37, 29);
    to.set(target.x, target.y);
    expect_exact(all, to);
  }
}

TEST(Distance, of_nothing_is_infinite) {
  const LineMap all = random_map(20, 20, 1, 0), none(20, 20);
  for (const int64_t squared : squared_distances(pixels_of(all), none)) EXPECT_EQ(squared, kInfinitelyFar);
  EXPECT_TRUE(squared_distances({}, all).empty());
}

TEST(Distance, near_distances_are_exact_in_every_band) {
  for (const double density : {0.0, 0.0005, 0.005, 0.05, 0.5, 1.0}) {
    for (const int width : {1, 3, 64, 97}) {
      const LineMap to = random_map(width, 61, density, static_cast<uint32_t>(width));
      for (const int rows : {1, 7, 61}) {
        for (int first = 0; first < 61; first += rows) {
          const int end = std::min(first + rows, 61);
          std::vector<uint8_t> band;
          near_distances(to, first, end, band);
          ASSERT_EQ(band.size(), static_cast<size_t>(width) * (end - first));
          for (int y = first; y < end; ++y) {
            for (int x = 0; x < width; ++x) {
              const int64_t exact = std::min<int64_t>(100, brute_force(x, y, to, true));
              ASSERT_EQ(band[static_cast<size_t>(y - first) * width + x], exact)
                  << x << ' ' << y << ' ' << density;
            }
          }
        }
      }
    }
  }
}

TEST(Distance, to_background_is_exact_in_thin_and_in_thick_ink) {
  LineMap thick = random_map(150, 120, 1, 0);
  thick.set(3, 5, false);
  thick.set(100, 70, false);
  thick.set(149, 119, false);
  for (const LineMap& map : {thick, random_map(100, 40, 0.6, 1), random_map(70, 40, 0.98, 2)}) {
    const std::vector<Pixel> pixels = pixels_of(map);
    const std::vector<int64_t> distances = squared_distances_to_background(pixels, map);
    for (size_t i = 0; i < pixels.size(); ++i) {
      ASSERT_EQ(distances[i], brute_force(pixels[i].x, pixels[i].y, map, false))
          << pixels[i].x << ' ' << pixels[i].y;
    }
  }
  const LineMap full = random_map(30, 30, 1, 0);
  EXPECT_EQ(squared_distances_to_background(pixels_of(full), full).front(), kInfinitelyFar);
}

}  // namespace
}  // namespace inkbench
