// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/score_curve_command.h"
#include "app/terminal.h"
#include "pipeline/base/error.h"
#include "pipeline/base/log.h"
#include "pipeline/base/text.h"
#include "pipeline/image/image_file.h"
#include "pipeline/line_file.h"
#include "pipeline/lines/class_pixels.h"
#include "studies/measures/diff_picture.h"
#include "studies/measures/measures.h"

namespace inkbench {
namespace {

using Json = nlohmann::ordered_json;

struct ScoreOptions {
  std::string prediction, reference, diff, invert = "auto", out;
  std::optional<double> tolerance_px, cut;
  bool json = false, curve = false;
};

/// What is compared, and how.
struct Scored {
  LineFile prediction, reference;
  std::optional<LineMap> allowed;  ///< Tier 2, where the reference says what it is.
  double tolerance_px = kTolerancePx;

  LinesToMeasure lines() const {
    return {.prediction = prediction.lines,
            .reference = reference.lines,
            .allowed = allowed ? &*allowed : nullptr,
            .tolerance_px = tolerance_px};
  }
};

std::string size_text(const LineMap& map) {
  return fmt::format("{} x {}", map.width_px(), map.height_px());
}

/// False of NaN, too.
void check_range(const char* option, const std::optional<double>& value, double from, double to,
                 const char* unit) {
  if (!value || (*value >= from && *value <= to)) return;
  throw input_error(option, fmt::format("{} is out of range", shortest(*value)),
                    fmt::format("give {} to {}{}", from, to, unit));
}

Invert invert_of(const std::string& word) {
  return word == "yes" ? Invert::yes : word == "no" ? Invert::no : Invert::automatic;
}

Scored read_both(const ScoreOptions& options) {
  check_range("--cut", options.cut, 0, 1, "");
  const LineFileOptions reading{invert_of(options.invert), options.cut};
  Scored scored{read_line_file(options.prediction, reading), read_line_file(options.reference, reading), {}};
  const LineMap &prediction = scored.prediction.lines, &reference = scored.reference.lines;
  if (!prediction.same_size(reference)) {
    throw input_error(
        options.prediction,
        fmt::format("is {}, but {} is {}", size_text(prediction), options.reference, size_text(reference)),
        "both must have the same size");
  }
  if (const auto& classes = scored.reference.classes) {
    scored.allowed = tier_map(classes->pixels, classes->judge, 2);
    scored.tolerance_px = classes->judge.tolerance;  // as the scene's judge has it
  }
  scored.tolerance_px = options.tolerance_px.value_or(scored.tolerance_px);
  return scored;
}

DrawingTally tally_of(const Scored& scored) {
  DrawingTally tally = tally_maps(scored.lines());
  if (const auto& classes = scored.reference.classes) {
    for (size_t i = 0; i < kLineClasses.size(); ++i)
      tally.recall[i] = tally_recall(scored.prediction.lines, class_map(classes->pixels, kLineClasses[i]),
                                     scored.tolerance_px);
  }
  return tally;
}

std::vector<std::string> notes_of(const Scored& scored) {
  std::vector<std::string> notes;
  for (const LineFile* file : {&scored.prediction, &scored.reference}) {
    for (const std::string& note : file->notes) {
      if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    }
  }
  return notes;
}

std::vector<std::string> classes_of_tier(const JudgeParams& judge, int wanted_tier) {
  std::vector<std::string> names;
  for (const LineClass line_class : kLineClasses) {
    if (tier(judge, line_class) == wanted_tier) names.emplace_back(name_of(line_class));
  }
  return names;
}

Json side_json(const std::string& path, const LineFile& file) {
  Json side{{"file", path}};
  side["buffer"] = file.buffer ? Json(name_of(*file.buffer)) : Json();
  side["inverted"] = file.cut.inverted;
  side["cut"] = file.classes ? Json() : Json(file.cut.value);
  if (file.classes) {
    side["wanted"] = classes_of_tier(file.classes->judge, 1);
    side["allowed"] = classes_of_tier(file.classes->judge, 2);
  }
  return side;
}

/// The measures' own text with what was decided behind it: their numbers stay as they are written.
std::string score_json(const ScoreOptions& options, const Scored& scored, const DrawingTally& tally) {
  std::string json = measures_json(measures_of_maps(scored.reference.classes.has_value()), tally);
  json.pop_back();
  Json decided{{"tolerance_px", scored.tolerance_px},
               {"prediction", side_json(options.prediction, scored.prediction)},
               {"reference", side_json(options.reference, scored.reference)},
               {"notes", notes_of(scored)}};
  return json + ", " + decided.dump(-1, ' ', false, Json::error_handler_t::replace).substr(1);
}

void print_table(const ScoreOptions& options, const Scored& scored, const DrawingTally& tally) {
  print_out("{} against {}, {}, tolerance {} px\n", options.prediction, options.reference,
            size_text(scored.prediction.lines), shortest(scored.tolerance_px));
  const auto& classes = scored.reference.classes;
  if (classes)
    print_out("wanted: {}; allowed: {}\n", join(classes_of_tier(classes->judge, 1), ", "),
              join(classes_of_tier(classes->judge, 2), ", "));
  if (tally.lines.empty())
    print_out("empty: neither has a line inside the border of {} px\n", kIgnoredBorderPx);
  print_out("{}", measures_table(measures_of_maps(classes.has_value()), tally));
  if (!options.diff.empty()) print_out("{}\n", options.diff);
}

void score_lines(const ScoreOptions& options) {
  const Scored scored = read_both(options);
  if (!options.diff.empty()) {
    const LinesToMeasure lines = scored.lines();
    write_png(options.diff,
              diff_picture(lines.prediction, lines.reference, lines.tolerance_px, lines.allowed), {});
  }
  const DrawingTally tally = tally_of(scored);
  for (const std::string& note : notes_of(scored)) log_note(note);
  if (options.json) return print_out("{}\n", score_json(options, scored, tally));
  print_table(options, scored, tally);
}

void score(const ScoreOptions& options) {
  check_range("--tolerance", options.tolerance_px, kToleranceFromPx, kToleranceToPx, " px");
  if (!options.curve) return score_lines(options);
  print_curve_score({options.prediction, options.reference, options.out, options.tolerance_px,
                     invert_of(options.invert), options.json});
}

}  // namespace

void add_score_command(CLI::App& app) {
  auto options = std::make_shared<ScoreOptions>();
  CLI::App* command = app.add_subcommand("score", "Measure drawn lines against reference lines");
  command
      ->add_option("PRED", options->prediction,
                   "The drawn lines: an image; with --curve a strength map or a folder of them")
      ->required();
  command
      ->add_option(
          "REF", options->reference,
          "The lines that should be there, of the same size; the buffer reference says its classes; with "
          "--curve an image, or a folder of images, BSDS500's .mat files or folders of annotators' "
          "images by the predictions' names")
      ->required();
  command->add_option("--tolerance", options->tolerance_px,
                      "How far apart two pixels may be to match, in px, 0 to 100; without it the reference's "
                      "judge.tolerance, or 2; with --curve 0.0075 x the diagonal");
  CLI::Option* cut = command->add_option(
      "--cut", options->cut, "Values from here on are line, 0 to 1; 0.5 without it (of 8 bits: over 127)");
  command
      ->add_option("--invert", options->invert,
                   "Lines are dark on light: yes, no, or auto (without it): of each image what is less ink, "
                   "with --curve "
                   "of all images of a side together")
      ->check(CLI::IsMember({"auto", "yes", "no"}));
  command->add_flag("--json", options->json, "Print one JSON object and nothing else");
  CLI::Option* diff =
      command->add_option("--diff", options->diff,
                          "Also write a PNG: matched black, missed blue, false vermillion, allowed grey");
  CLI::Option* curve = command->add_flag(
      "--curve", options->curve,
      "Strengths instead of lines: precision and recall at thresholds 0.01 to 0.99, ods, ois and ap");
  curve->excludes(cut)->excludes(diff);
  command
      ->add_option(
          "--out", options->out,
          "With --curve: also write score.json, curve.csv, images.csv and the chart into this folder")
      ->needs(curve);
  command->footer(
      "Images that inkbench wrote say themselves what of them is line.\n"
      "Examples:\n  inkbench render --buffers lines,reference --out out/a\n"
      "  inkbench score out/a/lines.png out/a/reference.png --diff out/diff.png\n"
      "  inkbench score scan.png out/a/reference.png --cut 0.4 --json\n"
      "  inkbench score outputs BSDS500/data/groundTruth/test --curve --out out/scores");
  command->callback([options] {
    hear_signals();
    score(*options);
  });
}

}  // namespace inkbench
