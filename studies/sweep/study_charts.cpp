// SPDX-License-Identifier: MIT
#include "studies/sweep/study_charts.h"

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "studies/report/chart.h"

namespace inkbench {

DrawnChart chart_in(const fs::path& folder, const Chart& chart) {
  return chart_files(folder / "charts", chart.name, chart.title);
}

DrawnChart draw_chart(const Chart& chart, const fs::path& folder) {
  const DrawnChart files = chart_in(folder, chart);
  draw_chart(chart_script(chart, parse_csv(read_file(folder / chart.table))), files);
  return files;
}

std::vector<DrawnChart> draw_study_charts(const StudySpec& spec, const fs::path& folder,
                                          std::vector<std::string>& failures) {
  std::vector<DrawnChart> result;
  for (const Chart& chart : spec.charts) {
    try {
      result.push_back(draw_chart(chart, folder));
    } catch (const Error& error) {
      failures.push_back("chart " + chart.name + ": " + error.what());
    }
  }
  return result;
}

}  // namespace inkbench
