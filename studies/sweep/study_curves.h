// SPDX-License-Identifier: MIT
// A finished study's charts of precision and recall over thresholds (`pr = true`). In: the counts of its
// cells. Out: a script, an SVG and a PNG for each chart.
#pragma once

#include <string>
#include <vector>

#include "studies/report/drawn_chart.h"
#include "studies/sweep/study_folder.h"

namespace inkbench {

/// One chart, or one for each variant: a curve for each value of the axis `edges.method`, else of the first
/// axis, else for each variant, with the counts of all its other cells added up.
struct CurveChartPlan {
  std::string name;  ///< Stem of its files.
  std::string title;
  std::vector<std::string> labels;         ///< Of the curves.
  std::vector<std::vector<size_t>> cells;  ///< Of each curve.
};

std::vector<CurveChartPlan> curve_charts(const StudySpec& spec);

/// The files of its charts, whether they are there or not.
std::vector<DrawnChart> curve_charts_in(const std::filesystem::path& folder, const StudySpec& spec);

/// Draws them from the cells that are finished. What fails is told in `failures`; the others are returned.
std::vector<DrawnChart> draw_study_curves(const StudySpec& spec, const StudyFolder& folder,
                                          std::vector<std::string>& failures);

}  // namespace inkbench
