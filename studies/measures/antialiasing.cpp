// SPDX-License-Identifier: MIT
#include "studies/measures/antialiasing.h"

#include <cmath>
#include <vector>

#include "studies/measures/distance.h"

namespace inkbench {
namespace {

constexpr int kNearLinePx = 3;

std::optional<double> root_of_mean(double squares, int64_t pixels) {
  if (pixels == 0) return std::nullopt;
  return std::sqrt(squares / static_cast<double>(pixels));
}

double squared(double value) {
  return value * value;
}

}  // namespace

void AntialiasingTally::add(const AntialiasingTally& other) {
  pixels += other.pixels;
  drawn_squares += other.drawn_squares;
  aliased_squares += other.aliased_squares;
}

std::optional<double> AntialiasingTally::drawn_rms() const {
  return root_of_mean(drawn_squares, pixels);
}

std::optional<double> AntialiasingTally::aliased_rms() const {
  return root_of_mean(aliased_squares, pixels);
}

AntialiasingTally tally_antialiasing(const Image& drawn, const Image& aliased, const Image& wanted) {
  LineMap lines(wanted.width_px, wanted.height_px);
  for (int y = 0; y < wanted.height_px; ++y) {
    for (int x = 0; x < wanted.width_px; ++x) lines.set(x, y, wanted.at(x, y) > 0.0F);
  }
  AntialiasingTally tally;
  std::vector<uint8_t> distances;
  for (int y = 0; y < wanted.height_px; ++y) {
    near_distances(lines, y, y + 1, distances);
    for (int x = 0; x < wanted.width_px; ++x) {
      if (distances[static_cast<size_t>(x)] > kNearLinePx * kNearLinePx) continue;
      ++tally.pixels;
      tally.drawn_squares += squared(drawn.at(x, y) - wanted.at(x, y));
      tally.aliased_squares += squared(aliased.at(x, y) - wanted.at(x, y));
    }
  }
  return tally;
}

}  // namespace inkbench
