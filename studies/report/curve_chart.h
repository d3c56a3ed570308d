// SPDX-License-Identifier: MIT
// The chart that contour benchmarks draw: precision over recall, a curve for each method, over lines of equal
// F. In: curves. Out: the text of a gnuplot script.
#pragma once

#include <string>
#include <vector>

#include "studies/report/chart_data.h"

namespace inkbench {

inline constexpr size_t kMostStrengthCurves = 16;

/// Precision (y) over recall (x), both 0 to 1.
struct StrengthCurveLine {
  std::string label;   ///< Of the method.
  std::string detail;  ///< Its numbers, below the label.
  CurvePoints points;  ///< By threshold.
  CurvePoint best;     ///< Of the best F.
};

struct StrengthChart {
  std::string name;  ///< Stem of its files.
  std::string title;
  std::string of, writer;                 ///< As `ScriptHead` has them.
  std::vector<StrengthCurveLine> curves;  ///< 1 to 16.
  std::vector<std::string> notes;
};

std::string strength_chart_script(const StrengthChart& chart);

}  // namespace inkbench
