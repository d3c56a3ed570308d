// SPDX-License-Identifier: MIT
// Counts by threshold as text and as a chart's line. In: counts. Out: CSV that reads back, lines with labels.
#pragma once

#include <string>
#include <string_view>

#include "studies/measures/strength_curve.h"
#include "studies/report/curve_chart.h"

namespace inkbench {

/// A table for people and programs: a row for each threshold with precision, recall, F and counts.
std::string curve_csv(const CurveCounts& curve);

/// The same with one row more, each picture at its own best threshold, so that it reads back.
std::string whole_curve_csv(const StrengthCurve& curve);

/// The reverse. Errors (work, at `where`): it is no such text.
StrengthCurve curve_from_csv(std::string_view text, const std::string& where);

/// Its numbers stand in `detail`; thresholds at which nothing is predicted have no point.
StrengthCurveLine chart_line(const std::string& label, const StrengthCurve& curve);

}  // namespace inkbench
