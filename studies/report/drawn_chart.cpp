// SPDX-License-Identifier: MIT
#include "studies/report/drawn_chart.h"

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/base/text.h"
#include "pipeline/image/image_content.h"
#include "pipeline/image/png_chunks.h"
#include "studies/report/chart_text.h"
#include "studies/report/gnuplot.h"
#include "studies/report/svg_text.h"

namespace inkbench {
namespace {

constexpr std::chrono::seconds kTimeLimit{120};

void remove_pictures(const DrawnChart& files) {
  std::error_code error;
  fs::remove(files.svg, error);
  fs::remove(files.png, error);
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

/// Errors and `Stopped` as `draw_chart`.
void draw(const std::string& script, const DrawnChart& files) {
  write_file_atomically(files.script, script);
  // Beside where it will stand: a picture takes its name only once it is whole.
  const ScratchFolder scratch(files.script.parent_path());
  run_gnuplot(files.script, scratch.path(), kTimeLimit);
  const std::string svg = whole_picture(scratch.path() / files.svg.filename(), files.script);
  const std::string png = whole_picture(scratch.path() / files.png.filename(), files.script);
  write_file_atomically(files.svg, scoped_svg(svg, "chart-" + files.name, one_line(files.title)));
  write_file_atomically(files.png, png);
}

}  // namespace

DrawnChart chart_files(const fs::path& folder, const std::string& name, const std::string& title) {
  const std::string stem = (folder / name).string();
  return {name, title, stem + ".svg", stem + ".png", stem + ".gp"};
}

void draw_chart(const std::string& script, const DrawnChart& files) {
  try {
    draw(script, files);
  } catch (...) {
    remove_pictures(files);
    throw;
  }
}

}  // namespace inkbench
