// SPDX-License-Identifier: MIT
// The box that a search looks through: a side for each parameter, and points of it as shares of the sides.
// In: points. Out: values of parameters, and settings that have them.
#pragma once

#include <string>
#include <vector>

#include "pipeline/settings/settings.h"

namespace inkbench {

/// One parameter that is searched.
struct SearchAxis {
  std::string key;
  double from = 0, to = 1;      ///< Of a number.
  Scale scale = Scale::linear;  ///< Steps along a log side are ratios.
  bool is_whole = false;        ///< Only whole numbers are values.
  std::vector<Value> choices;   ///< Of what is no number, at least one; empty for numbers.

  bool is_number() const { return choices.empty(); }
};

using SearchSpace = std::vector<SearchAxis>;

/// A share of each side, 0 to 1; of choices [i / n, (i + 1) / n) is the i-th of n.
using Point = std::vector<double>;

/// A value for each side.
using Values = std::vector<Value>;

/// Numbers have four significant digits: no more can be told from a picture, and people can read them.
Value value_at(const SearchAxis& axis, double share);
Values values_at(const SearchSpace& space, const Point& point);

/// The share at which the side has the value, in 0 to 1: the nearest end for a number beyond it, the middle
/// of a choice; 0 for a choice that is none of its.
double share_of(const SearchAxis& axis, const Value& value);
Point point_of(const SearchSpace& space, const Values& values);

/// What the settings have at the searched keys.
Values values_of(const SearchSpace& space, const Settings& settings);
/// The settings with these values. Errors (input): one that the parameter does not accept.
Settings with_values(const Settings& settings, const SearchSpace& space, const Values& values);

/// Whether the parameter has an effect in these settings, by what its description says.
bool has_effect(const Settings& settings, const std::string& key);

/// "combine.k_depth = 0.003, edges.use_depth = true".
std::string values_text(const SearchSpace& space, const Values& values);

}  // namespace inkbench
