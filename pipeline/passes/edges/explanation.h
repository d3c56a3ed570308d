// SPDX-License-Identifier: MIT
// Why a pixel is a line or not, as data that any edge detector gives and that the window and the command line
// show: the terms of its decision, each with what it was made from.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/params/value.h"

namespace inkbench {

/// From the explained pixel: dx to the right, dy downwards.
struct Offset {
  int dx = 0, dy = 0;
  bool operator==(const Offset&) const = default;
};

/// A number that a term was made from.
struct ExplainedInput {
  enum class Role { plain, largest, smallest };

  std::string name;  ///< "gmax"
  double value = 0;
  std::string unit;  ///< "deg", "px"; empty for plain numbers.
  Role role = Role::plain;
  std::optional<Offset> at;  ///< Where it was read.
};

/// A part of the decision.
struct ExplainedTerm {
  std::string name;   ///< "depth"
  std::string title;  ///< "Depth term"
  bool used = true;
  double value = 0;  ///< What it adds; by the largest, what it has.
  double limit = 1;  ///< The most that it can add; by the largest, what it needs for a line.
  std::string unit;
  std::vector<ExplainedInput> inputs;
  /// What it looked at in the 3 x 3 pixels around, row by row from the top left; none outside the image.
  std::array<std::optional<float>, 9> around;
  std::string cause;  ///< "normals 62 degrees apart between box and room"; empty where nothing stands out.
};

/// A value of one parameter that alone, by the same maps, makes a line of what is none, or none of a line.
struct ExplainedChange {
  std::string parameter;  ///< "combine.k_depth"
  Value value, now;       ///< A number with few digits, just beyond the one at which it changes; or a switch.
};

struct Explanation {
  std::string detector;
  int x = 0, y = 0;
  bool by_largest = false;  ///< The term that has the largest share of its limit decides, and no sum.
  std::vector<ExplainedTerm> terms;
  double sum = 0,
         limit = 0;  ///< A line needs this much; its strength is sum / limit. By the largest: its share, 1.
  std::string limit_name;  ///< "threshold"
  std::string unit;        ///< Of both.
  double edge = 0;         ///< What the detector stores for it, by the terms.
  double drawn = 0;        ///< What it stored.
  bool is_line = false;    ///< By the terms: detected. What is thinned afterwards may leave it out.
  std::string line_class;  ///< "object", "silhouette", "crease": what the line is of; empty without one.
  std::vector<ExplainedChange> changes;  ///< In the order of the detector's parameters.
  std::string verdict;  ///< "A line, because the sum of the terms, 1.2, reaches the threshold 0.75."
};

}  // namespace inkbench
