// SPDX-License-Identifier: MIT
#include "studies/measures/histogram.h"

#include <cassert>
#include <cmath>

namespace inkbench {

void Histogram::add(int64_t value, int64_t count) {
  assert(value >= 0);
  (value < kSmall ? small_[value] : large_[value]) += count;
  total_ += count;
}

void Histogram::add(const Histogram& other) {
  other.for_each([this](int64_t value, int64_t count) { add(value, count); });
}

void Histogram::for_each(const std::function<void(int64_t, int64_t)>& use) const {
  for (int64_t value = 0; value < kSmall; ++value) {
    if (small_[value] != 0) use(value, small_[value]);
  }
  for (const auto& [value, count] : large_) use(value, count);
}

std::vector<std::pair<int64_t, int64_t>> Histogram::counts() const {
  std::vector<std::pair<int64_t, int64_t>> counts;
  for_each([&](int64_t value, int64_t count) { counts.emplace_back(value, count); });
  return counts;
}

double Histogram::mean(const Map& map) const {
  if (total_ == 0) return 0;
  double sum = 0;
  for_each([&](int64_t value, int64_t count) { sum += map(value) * static_cast<double>(count); });
  return sum / static_cast<double>(total_);
}

double Histogram::deviation(const Map& map) const {
  const double centre = mean(map);
  return std::sqrt(mean([&](int64_t value) { return (map(value) - centre) * (map(value) - centre); }));
}

double Histogram::at_rank(int64_t rank, const Map& map) const {
  int64_t found = 0, seen = 0;
  for_each([&](int64_t value, int64_t count) {
    if (seen <= rank) found = value;
    seen += count;
  });
  return map(found);
}

double Histogram::quantile(double q, const Map& map) const {
  if (total_ == 0) return 0;
  const double position = q * static_cast<double>(total_ - 1);
  const double share = position - std::floor(position);
  const auto rank = static_cast<int64_t>(position);
  const double low = at_rank(rank, map);
  if (share == 0 || std::isinf(low)) return low;
  return low + share * (at_rank(rank + 1, map) - low);
}

}  // namespace inkbench
