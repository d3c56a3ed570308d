// SPDX-License-Identifier: MIT
#include "studies/sweep/study_charts.h"

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/base/text.h"
#include "pipeline/image/image_content.h"
#include "pipeline/image/png_chunks.h"
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

/// The file that gnuplot drew, which does not tell of a full disk. Errors (work): it is not whole.
std::string whole_picture(const fs::path& path, const fs::path& script) {
  std::error_code error;
  const std::string content = fs::is_regular_file(path, error) ? read_file(path, kMostImageBytes) : "";
  const bool is_svg = path.extension() == ".svg";
  const bool is_whole = is_svg ? trim(content).ends_with("</svg>")
                               : is_png(content) && !is_cut_off(content) && png_sums_are_right(content);
  if (is_whole) return content;
  throw work_error(script.string(), "gnuplot left " + path.filename().string() + " cut off",
                   "is the disk full?");
}

void draw(const Chart& chart, const CsvTable& table, const DrawnChart& drawn) {
  write_file_atomically(drawn.script, chart_script(chart, table));
  // Beside where it will stand: a picture takes its name only once it is whole.
  const ScratchFolder scratch(drawn.script.parent_path());
  run_gnuplot(drawn.script, scratch.path(), kTimeLimit);
  const std::string svg = whole_picture(scratch.path() / drawn.svg.filename(), drawn.script);
  const std::string png = whole_picture(scratch.path() / drawn.png.filename(), drawn.script);
  write_file_atomically(drawn.svg, scoped_svg(svg, "chart-" + chart.name, one_line(chart.title)));
  write_file_atomically(drawn.png, png);
}

}  // namespace

DrawnChart chart_in(const fs::path& folder, const Chart& chart) {
  const std::string stem = (folder / "charts" / chart.name).string();
  return {chart.name, chart.title, stem + ".svg", stem + ".png", stem + ".gp"};
}

DrawnChart draw_chart(const Chart& chart, const fs::path& folder) {
  DrawnChart drawn = chart_in(folder, chart);
  try {
    draw(chart, parse_csv(read_file(folder / chart.table)), drawn);
  } catch (...) {
    remove_pictures(drawn);
    throw;
  }
  return drawn;
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
