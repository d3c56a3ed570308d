// SPDX-License-Identifier: MIT
#include "app/workbench/duration_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace inkbench {

std::string duration_text(double seconds) {
  constexpr double kLongest = 1e12;  // what a long holds
  const long whole = std::lround(std::ceil(std::clamp(seconds, 0.0, kLongest)));
  if (whole < 100) return fmt::format("{} s", whole);
  if (whole < 6000) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace inkbench
