// SPDX-License-Identifier: MIT
#include "studies/measures/stroke_tally.h"

#include <algorithm>
#include <cmath>

namespace inkbench {

void StrokeTally::add(const StrokeTally& other) {
  shifts_px.insert(shifts_px.end(), other.shifts_px.begin(), other.shifts_px.end());
  strokes += other.strokes;
  broken += other.broken;
}

std::optional<double> StrokeTally::median_shift_px() const {
  if (shifts_px.empty()) return std::nullopt;
  std::vector<float> sizes;
  sizes.reserve(shifts_px.size());
  for (const float shift : shifts_px) sizes.push_back(std::abs(shift));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

std::optional<double> StrokeTally::broken_share() const {
  if (strokes == 0) return std::nullopt;
  return static_cast<double>(broken) / static_cast<double>(strokes);
}

}  // namespace inkbench
