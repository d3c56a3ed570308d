// SPDX-License-Identifier: MIT
// From a chart's script to its files: the script, an SVG that can stand in a page with others, and a PNG.
#pragma once

#include <filesystem>
#include <string>

namespace inkbench {

struct DrawnChart {
  std::string name, title;
  std::filesystem::path svg, png, script;
};

/// The files of a chart of that name in a folder, whether they are there or not.
DrawnChart chart_files(const std::filesystem::path& folder, const std::string& name,
                       const std::string& title);

/// Writes `script`, runs gnuplot on it, and writes what it drew once it is whole. Where that fails or is
/// stopped, there are no pictures but, if it got that far, the script. Errors (work): as `run_gnuplot`; a
/// full disk. Throws `Stopped`.
void draw_chart(const std::string& script, const DrawnChart& files);

}  // namespace inkbench
