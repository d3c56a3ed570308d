// SPDX-License-Identifier: MIT
// A finished study's charts: from the spec and data.csv to a script, an SVG and a PNG each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/report/drawn_chart.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// The files of one of the study's charts, whether they are there or not.
DrawnChart chart_in(const std::filesystem::path& folder, const Chart& chart);

/// Draws charts/NAME.gp, .svg and .png of its table, which lies in the folder. Errors (input): as
/// `chart_script`; (work): gnuplot fails or is not there, full disk. Leaves no picture that is not whole.
DrawnChart draw_chart(const Chart& chart, const std::filesystem::path& folder);

/// Reads `folder`/data.csv and writes charts/NAME.gp, .svg and .png. What fails is told in `failures`; a
/// chart that failed has no pictures but, if it got that far, its script. The others are returned.
std::vector<DrawnChart> draw_study_charts(const StudySpec& spec, const std::filesystem::path& folder,
                                          std::vector<std::string>& failures);

}  // namespace inkbench
