#include "studies/sweep/study_charts.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "studies/report/chart.h"
#include "studies/report/chart_text.h"
#include "studies/report/gnuplot.h"
#include "studies/report/svg_text.h"

namespace inkbench {
namespace {

constexpr std::chrono::seconds kTimeLimit{120};

/// Where gnuplot writes, so that a picture takes its name only once it is whole.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    if (error) throw work_error(parent.string(), "there is no folder for temporary files", error.message());
    std::string pattern = (parent / "inkbench_chart_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw work_error(pattern, "cannot be made", std::strerror(errno));
    path_ = pattern;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void remove_pictures(const DrawnChart& drawn) {
  std::error_code error;
  fs::remove(drawn.svg, error);
  fs::remove(drawn.png, error);
}

void draw(const Chart& chart, const CsvTable& table, const DrawnChart& drawn) {
  write_file_atomically(drawn.script, chart_script(chart, table));
  const ScratchFolder scratch;
  run_gnuplot(drawn.script, scratch.path(), kTimeLimit);
  const std::string svg = read_file(scratch.path() / drawn.svg.filename());
  const std::string png = read_file(scratch.path() / drawn.png.filename());
  write_file_atomically(drawn.svg, scoped_svg(svg, "chart-" + chart.name, one_line(chart.title)));
  write_file_atomically(drawn.png, png);
}

}  // namespace

std::vector<DrawnChart> draw_study_charts(const StudySpec& spec, const fs::path& folder,
                                          std::vector<std::string>& failures) {
  std::vector<DrawnChart> result;
  for (const Chart& chart : spec.charts) {
    const std::string stem = (folder / "charts" / chart.name).string();
    DrawnChart drawn{chart.name, chart.title, stem + ".svg", stem + ".png", stem + ".gp"};
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
