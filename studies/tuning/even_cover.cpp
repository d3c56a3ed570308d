// SPDX-License-Identifier: MIT
#include "studies/tuning/even_cover.h"

#include <algorithm>
#include <cmath>

namespace inkbench {
namespace {

constexpr int kLeastGridSide = 5;  // a coarser one would see little but the ends

/// In how many values a grid has each side; empty where it is no grid.
std::vector<int> grid_counts(const SearchSpace& space, int most) {
  const auto numbers = std::count_if(space.begin(), space.end(), [](const auto& a) { return a.is_number(); });
  double combinations = 1;
  for (const SearchAxis& axis : space)
    combinations *= static_cast<double>(std::max<size_t>(axis.choices.size(), 1));
  if (numbers > 2 || combinations > most) return {};
  const double room = most / combinations;
  const int side =
      numbers == 0 ? 1 : static_cast<int>(std::pow(room, 1.0 / static_cast<double>(numbers)) + 1e-9);
  if (numbers > 0 && side < kLeastGridSide) return {};
  std::vector<int> counts;
  for (const SearchAxis& axis : space) {
    const double whole = axis.to - axis.from + 1;
    const int values = axis.is_whole && whole < side ? static_cast<int>(whole) : side;
    counts.push_back(axis.is_number() ? values : static_cast<int>(axis.choices.size()));
  }
  return counts;
}

/// The first number fastest, choices slowest, so that what costs most to change is changed least.
std::vector<Point> grid(const SearchSpace& space, const std::vector<int>& counts) {
  std::vector<size_t> order;
  for (const bool numbers : {true, false}) {
    for (size_t i = 0; i < space.size(); ++i) {
      if (space[i].is_number() == numbers) order.push_back(i);
    }
  }
  std::vector<Point> points;
  std::vector<int> place(space.size(), 0);
  for (bool more = true; more;) {
    Point point(space.size());
    for (size_t i = 0; i < space.size(); ++i) {
      const double last = std::max(counts[i] - 1, 1);
      point[i] = space[i].is_number() ? place[i] / last : (place[i] + 0.5) / counts[i];
    }
    points.push_back(std::move(point));
    more = false;
    for (const size_t i : order) {
      if (++place[i] < counts[i]) {
        more = true;
        break;
      }
      place[i] = 0;
    }
  }
  return points;
}

std::vector<int> first_primes(size_t count) {
  std::vector<int> primes;
  for (int n = 2; primes.size() < count; ++n) {
    if (std::none_of(primes.begin(), primes.end(), [n](int prime) { return n % prime == 0; }))
      primes.push_back(n);
  }
  return primes;
}

/// The digits of `n` in that base, turned over behind the point.
double radical_inverse(int n, int base) {
  double result = 0, place = 1.0 / base;
  for (; n > 0; n /= base, place /= base) result += place * (n % base);
  return result;
}

/// Turned by a share of each side that follows from the seed.
std::vector<Point> halton(size_t dimensions, int count, uint64_t seed) {
  const std::vector<int> bases = first_primes(dimensions);
  std::vector<Point> points;
  for (int n = 0; n < count; ++n) {
    Point point(dimensions);
    for (size_t i = 0; i < dimensions; ++i) {
      const double turn = static_cast<double>(seed % 65536) * std::sqrt(static_cast<double>(bases[i]));
      const double at = radical_inverse(n + 1, bases[i]) + turn;
      point[i] = at - std::floor(at);
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace

std::vector<Point> even_cover(const SearchSpace& space, int most, uint64_t seed) {
  const std::vector<int> counts = grid_counts(space, most);
  return counts.empty() ? halton(space.size(), std::max(most, 1), seed) : grid(space, counts);
}

}  // namespace inkbench
