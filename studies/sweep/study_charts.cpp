// SPDX-License-Identifier: MIT
#include "studies/sweep/study_charts.h"

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/scratch_folder.h"
#include "studies/report/chart.h"
#include "studies/report/chart_text.h"
#include "studies/report/gnuplot.h"
#include "studies/report/svg_text.h"

namespace inkbench {
namespace {

constexpr std::chrono::seconds kTimeLimit{120};

void remove_pictures(const DrawnChart& drawn) {
  std::error_code error;
  fs::remove(drawn.svg, error);
  fs::remove(drawn.png, error);
}

void draw(const Chart& chart, const CsvTable& table, const DrawnChart& drawn) {
  write_file_atomically(drawn.script, chart_script(chart, table));
  const ScratchFolder scratch;  // a picture takes its name only once it is whole
  run_gnuplot(drawn.script, scratch.path(), kTimeLimit);
  const std::string svg = read_file(scratch.path() / drawn.svg.filename());
  const std::string png = read_file(scratch.path() / drawn.png.filename());
  write_file_atomically(drawn.svg, scoped_svg(svg, "chart-" + chart.name, one_line(chart.title)));
  write_file_atomically(drawn.png, png);
}

}  // namespace

DrawnChart chart_in(const fs::path& folder, const Chart& chart) {
  const std::string stem = (folder / "charts" / chart.name).string();
  return {chart.name, chart.title, stem + ".svg", stem + ".png", stem + ".gp"};
}

std::vector<DrawnChart> draw_study_charts(const StudySpec& spec, const fs::path& folder,
                                          std::vector<std::string>& failures) {
  std::vector<DrawnChart> result;
  for (const Chart& chart : spec.charts) {
    DrawnChart drawn = chart_in(folder, chart);
    try {
      draw(chart, parse_csv(read_file(folder / "data.csv")), drawn);
      result.push_back(std::move(drawn));
    } catch (const Error& error) {
      remove_pictures(drawn);
      failures.push_back("chart " + chart.name + ": " + error.what());
    }
  }
  return result;
}

}  // namespace inkbench
