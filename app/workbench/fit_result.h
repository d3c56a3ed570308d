// SPDX-License-Identifier: MIT
// What a search found, read from what `inkbench tune` leaves: the values, what they are worth, and how good
// each parameter's other values are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/settings/settings.h"

namespace inkbench {

/// How good the values of one parameter are, for showing them along its slider.
struct ValueHeat {
  struct Point {
    double value = 0;
    double warmth = 0;  ///< 1: as good as the best; 0: a tenth worse, or not drawn.
    bool operator==(const Point&) const = default;
  };
  std::vector<Point> points;                              ///< By value, at least two.
  std::optional<std::pair<double, double>> equally_good;  ///< Within 0.01 of the best.
};

struct FittedParameter {
  std::string key;
  std::string value;    ///< As text of a value: "0.004217", "\"both\"".
  bool matters = true;  ///< False where it is known to change nothing beside the others.
  std::optional<ValueHeat> heat;
};

struct FitResult {
  std::optional<double> before,
      after;  ///< The objective: F, or that of marks. `before` is that of the settings at the start.
  std::optional<double> left_out;  ///< Judged on each camera with values found without it.
  bool is_gain = true;             ///< False where that is no better than `before`.
  std::vector<FittedParameter> parameters;
  std::vector<std::string> marks;  ///< What became of the marks, a sentence each.
  size_t candidates = 0;
  bool stopped = false;

  bool is_better() const { return before && after && *after > *before; }
};

/// Errors (input): a file is missing or broken.
FitResult read_fit_result(const std::filesystem::path& folder);

/// The settings with the found values. Errors (input): they have no such parameter any more.
Settings with_fit(const Settings& settings, const FitResult& result);

/// "k_normal and threshold do not matter here"; "" where all do.
std::string indifferent_text(const FitResult& result);

}  // namespace inkbench
