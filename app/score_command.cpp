// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "pipeline/base/error.h"
#include "pipeline/base/log.h"
#include "pipeline/base/text.h"
#include "pipeline/image/image_file.h"
#include "studies/measures/diff_picture.h"
#include "studies/measures/measures.h"

namespace inkbench {
namespace {

struct ScoreOptions {
  std::string prediction, reference, diff;
  double tolerance_px = kTolerancePx;
  bool json = false;
};

std::string size_text(const LineMap& map) {
  return fmt::format("{} x {}", map.width_px(), map.height_px());
}

void check_tolerance(double tolerance_px) {
  if (tolerance_px >= kToleranceFromPx && tolerance_px <= kToleranceToPx) return;  // false for NaN too
  throw input_error("--tolerance", fmt::format("{} is out of range", shortest(tolerance_px)),
                    fmt::format("give {} to {} px", kToleranceFromPx, kToleranceToPx));
}

/// Black lines on white are the usual mistake, and every number would be about the paper.
void note_if_inverted(const std::string& path, const LineMap& map) {
  const int64_t pixels = int64_t{map.width_px()} * map.height_px();
  if (2 * map.count() <= pixels) return;
  log_note(path + " is more than half line: lines are white (over 127) on black");
}

void score(const ScoreOptions& options) {
  check_tolerance(options.tolerance_px);
  const LineMap prediction = read_line_map(options.prediction), reference = read_line_map(options.reference);
  if (!prediction.same_size(reference)) {
    throw input_error(
        options.prediction,
        fmt::format("is {}, but {} is {}", size_text(prediction), options.reference, size_text(reference)),
        "both must have the same size");
  }
  if (!options.diff.empty()) {
    write_png(options.diff, diff_picture(prediction, reference, options.tolerance_px), {});
  }
  const DrawingTally tally =
      tally_maps({.prediction = prediction, .reference = reference, .tolerance_px = options.tolerance_px});
  if (options.json) {
    fmt::print("{}\n", measures_json(measures_of_maps(), tally));
    return;
  }
  note_if_inverted(options.prediction, prediction);
  note_if_inverted(options.reference, reference);
  fmt::print("{} against {}, {}, tolerance {} px\n", options.prediction, options.reference,
             size_text(prediction), shortest(options.tolerance_px));
  if (tally.lines.empty())
    fmt::print("empty: neither has a line inside the border of {} px\n", kIgnoredBorderPx);
  fmt::print("{}", measures_table(measures_of_maps(), tally));
  if (!options.diff.empty()) fmt::print("{}\n", options.diff);
}

}  // namespace

void add_score_command(CLI::App& app) {
  auto options = std::make_shared<ScoreOptions>();
  CLI::App* command = app.add_subcommand("score", "Measure drawn lines against reference lines");
  command->add_option("PRED", options->prediction, "The drawn lines: an image, over 127 = line")->required();
  command->add_option("REF", options->reference, "The lines that should be there, of the same size")
      ->required();
  command->add_option("--tolerance", options->tolerance_px,
                      "How far apart two pixels may be to match, in px, 0 to 100; 2 without it");
  command->add_flag("--json", options->json, "Print one JSON object and nothing else");
  command->add_option("--diff", options->diff,
                      "Also write a PNG: matched black, missed blue, false vermillion");
  command->footer(
      "Example:\n  inkbench score out/a/combined_edges.png out/b/combined_edges.png --diff out/diff.png");
  command->callback([options] { score(*options); });
}

}  // namespace inkbench
