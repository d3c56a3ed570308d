// SPDX-License-Identifier: MIT
#include "app/score_curve_command.h"

#include <unistd.h>

#include <cstdio>

#include "app/terminal.h"
#include "pipeline/base/log.h"
#include "studies/scoring/score_files.h"

namespace inkbench {
namespace {

/// "12 / 200 images" on a terminal, which renews itself; nothing elsewhere.
class ImageProgress {
 public:
  void show(size_t done, size_t total) const {
    if (!is_terminal_ || total == 1) return;
    const bool is_last = done == total;
    fmt::print(stderr, "\r\033[K{}", is_last ? "" : fmt::format("{} / {} images", done, total));
    std::fflush(stderr);
  }

 private:
  bool is_terminal_ = isatty(STDERR_FILENO) == 1;
};

}  // namespace

void print_curve_score(const ScoreCurveOptions& options) {
  const CurveQuestion question{options.predictions, options.references, options.tolerance_px};
  const ImageProgress progress;
  const CurveScoreOptions scoring{
      .tolerance_px = options.tolerance_px,
      .invert = options.invert,
      .on_progress = [&](size_t done, size_t total) { progress.show(done, total); }};
  const CurveScore score = score_curve(pair_images(options.predictions, options.references), scoring);
  for (const std::string& note : score.notes) log_note(note);
  if (!options.out.empty()) write_score_files(options.out, question, score);
  if (options.json) return print_out("{}\n", score_json(question, score));
  print_out("{}", score_table(question, score));
  if (!options.out.empty())
    print_out("{}: score.json, curve.csv, images.csv, curve.svg, curve.png\n", options.out);
}

}  // namespace inkbench
