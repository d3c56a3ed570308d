// SPDX-License-Identifier: MIT
// Axes of charts: which range they show and where their ticks stand. In: values, the axis's length and the
// size of its lettering. Out: numbers and labels that fit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/params/description.h"

namespace inkbench {

constexpr int kTurnedDegrees = 35;

struct ChartTick {
  double at = 0;
  std::string label;
};

struct ChartAxis {
  bool is_log = false;
  double low = 0, high = 1;
  std::vector<ChartTick> ticks;
  std::vector<double> minor;       ///< Ticks without a label.
  std::optional<double> break_at;  ///< Beyond it stands what has no place on the axis.
  bool is_turned = false;          ///< The labels rise to the right, towards their ticks.
  int labels_px = 0;               ///< Extent of the labels across the axis, of a horizontal one.

  /// Where a value stands between the ends: 0 to 1.
  double part(double value) const;
};

/// What an axis must show, and on how much paper.
struct AxisNeeds {
  double low = 0, high = 0;  ///< Of the values; low <= high, above 0 on a log axis.
  Scale scale = Scale::linear;
  std::optional<double> from, to;  ///< Ends that were asked for.
  std::optional<ChartTick> apart;  ///< Stands outside the values, behind a break of the axis.
  int length_px = 0;
  int size_px = 0;        ///< Of the lettering.
  bool is_whole = false;  ///< No ticks between whole numbers.
};

/// An axis whose ends stand a little outside the values, ticks wherever their labels fit beside each other.
ChartAxis horizontal_axis(const AxisNeeds& needs);

/// An axis that ends at ticks, from 0 where that costs little.
ChartAxis vertical_axis(const AxisNeeds& needs);

/// Names, or numbers that stand at even distances, at 1, 2, 3, ...; turned or left out where they do not fit.
ChartAxis category_axis(const std::vector<std::string>& labels, bool are_names, int length_px, int size_px);

/// The same from the bottom up: no label is turned.
ChartAxis upright_category_axis(const std::vector<std::string>& labels, int length_px, int size_px);

/// Ticks within [low, high] for a colour scale that ends at its values.
ChartAxis scale_axis(const AxisNeeds& needs);

/// Decimals that tell values from `low` to `high` apart in `steps` steps; of a single value, its first three
/// digits.
int decimals_for(double low, double high, int steps);

}  // namespace inkbench
