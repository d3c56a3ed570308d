// SPDX-License-Identifier: MIT
// How often each whole number occurs: squared distances, which pool over views exactly by adding counts. In:
// numbers. Out: means and quantiles of a function of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace inkbench {

class Histogram {
 public:
  using Map = std::function<double(int64_t)>;

  void add(int64_t value, int64_t count = 1);
  void add(const Histogram& other);
  int64_t total() const { return total_; }
  /// Each value that occurs, rising, and how often.
  std::vector<std::pair<int64_t, int64_t>> counts() const;

  /// The mean of `map(value)`; 0 where there are none.
  double mean(const Map& map) const;
  /// The standard deviation of `map(value)`, divided by n, not n - 1; 0 where there are none.
  double deviation(const Map& map) const;
  /// The quantile q, 0 to 1, of `map(value)` for a rising `map`: linear between the two values whose ranks
  /// surround q (n - 1), ranks counted from 0. 0 where there are none; infinite where one of the two is.
  double quantile(double q, const Map& map) const;

 private:
  void for_each(const std::function<void(int64_t value, int64_t count)>& use) const;
  double at_rank(int64_t rank, const Map& map) const;

  static constexpr int64_t kSmall = 128;
  std::array<int64_t, kSmall> small_{};  ///< Counts of 0 to 127, nearly all there is.
  std::map<int64_t, int64_t> large_;
  int64_t total_ = 0;
};

}  // namespace inkbench
