// SPDX-License-Identifier: MIT
#include "studies/measures/strength_levels.h"

#include <algorithm>
#include <array>

namespace inkbench {
namespace {

uint8_t level_of(float strength) {
  constexpr double kRounding = 1e-6;  // LineCut's
  const double reached = (static_cast<double>(strength) + kRounding) * (kThresholds + 1);
  return reached >= 1 ? static_cast<uint8_t>(std::min<double>(reached, kThresholds)) : uint8_t{0};
}

}  // namespace

StrengthLevels levels_of(const Image& strengths) {
  assert(strengths.channels == 1);
  StrengthLevels levels(strengths.width_px, strengths.height_px, 1);
  std::transform(strengths.samples.begin(), strengths.samples.end(), levels.samples.begin(),
                 [](float strength) { return level_of(strength); });
  return levels;
}

FallingCut::FallingCut(const StrengthLevels& levels)
    : end_(kThresholds), map_(levels.width_px, levels.height_px) {
  std::array<size_t, kThresholds + 1> count{};
  for (const uint8_t level : levels.samples) ++count[level];
  std::array<size_t, kThresholds + 1> next{};
  size_t total = 0;
  for (int level = kThresholds; level > 0; --level) {
    next[level] = total;
    total += count[level];
    end_[level - 1] = total;
  }
  pixels_.resize(total);
  for (int y = 0; y < levels.height_px; ++y) {
    for (int x = 0; x < levels.width_px; ++x) {
      if (const uint8_t level = levels.at(x, y); level > 0) pixels_[next[level]++] = {x, y};
    }
  }
}

const LineMap& FallingCut::at(int number) {
  assert(drawn_ <= end_[number]);
  for (; drawn_ < end_[number]; ++drawn_) map_.set(pixels_[drawn_].x, pixels_[drawn_].y);
  return map_;
}

}  // namespace inkbench
