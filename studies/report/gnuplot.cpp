// SPDX-License-Identifier: MIT
#include "studies/report/gnuplot.h"

#include <string>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/run_program.h"
#include "pipeline/base/text.h"
#include "studies/report/chart_text.h"

namespace inkbench {
namespace {

constexpr size_t kMostSaid = 400;  ///< Characters of an error message.

/// What gnuplot said, on one line: the line that names the script's line, without the quoted script above it.
std::string said(const std::string& output) {
  std::vector<std::string> lines;
  for (const std::string& line : split(output, '\n')) {
    const std::string_view text = trim(line);
    if (!text.empty()) lines.emplace_back(text);
    if (text.starts_with("\"") && text.find(" warning: ") == std::string_view::npos) {
      lines = {std::string(text)};
      break;
    }
  }
  if (lines.empty()) return "it said nothing";
  std::string result = one_line(join(lines, " / "));
  if (result.size() > kMostSaid) result = result.substr(0, kMostSaid) + " ...";
  return result;
}

}  // namespace

std::string run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& folder,
                        std::chrono::milliseconds limit) {
  ProgramEnd end = run_program({"gnuplot", "-d", "-e", "out = " + literal(folder.string() + "/"),
                                std::filesystem::absolute(script).string()},
                               limit, "install the package gnuplot-nox, which draws the charts");
  if (end.status > 128)
    throw work_error(script.string(), "gnuplot was ended by signal " + std::to_string(end.status - 128));
  if (end.status != 0) throw work_error(script.string(), "gnuplot failed", said(end.output));
  return end.output;
}

}  // namespace inkbench
