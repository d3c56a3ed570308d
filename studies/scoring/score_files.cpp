// SPDX-License-Identifier: MIT
#include "studies/scoring/score_files.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "studies/measures/curve_text.h"
#include "studies/report/csv.h"

namespace inkbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDiagonalShare = 0.0075;

Json json_of(const StrengthCounts& counts) {
  return {{"precision", precision_of(counts)},
          {"recall", recall_of(counts)},
          {"f1", f_of(counts)},
          {"predicted", counts.predicted},
          {"right", counts.right},
          {"referenced", counts.referenced},
          {"found", counts.found}};
}

Json at_threshold(int number, const StrengthCounts& counts) {
  Json entry{{"threshold", threshold_of(number)}};
  entry.update(json_of(counts));
  return entry;
}

std::string tolerance_text(const CurveQuestion& question) {
  return question.tolerance_px ? shortest(*question.tolerance_px) + " px"
                               : shortest(kDiagonalShare) + " x diagonal";
}

std::string images_csv(const CurveScore& score) {
  std::string text = csv_line(std::vector<std::string>{"image", "threshold", "precision", "recall", "f1",
                                                       "predicted", "right", "referenced", "found"});
  for (const ImageScore& image : score.images) {
    const StrengthCounts& counts = image.counts;
    text += csv_line(std::vector<std::string>{
        image.name, fmt::format("{:.2f}", threshold_of(image.threshold)), shortest(precision_of(counts)),
        shortest(recall_of(counts)), shortest(f_of(counts)), std::to_string(counts.predicted),
        std::to_string(counts.right), std::to_string(counts.referenced), std::to_string(counts.found)});
  }
  return text;
}

std::string file_or_folder_name(const std::string& path) {
  const fs::path normal = fs::path(path).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).filename().string();
}

StrengthChart chart_of(const CurveQuestion& question, const CurveScore& score) {
  const std::string images = counted(score.images.size(), "image", "images");
  return {.name = "curve",
          .title = "Precision and recall, " + images,
          .of = "made by `inkbench score --curve`",
          .writer = "`inkbench score`",
          .curves = {chart_line(file_or_folder_name(question.predictions), score.curve)},
          .notes = {"Tolerance " + tolerance_text(question) + ". Thin lines: equal F."}};
}

}  // namespace

std::string score_json(const CurveQuestion& question, const CurveScore& score) {
  const StrengthCurve& curve = score.curve;
  Json json{{"ods", curve.ods()}, {"ois", curve.ois()}, {"ap", curve.ap() ? Json(*curve.ap()) : Json()}};
  json["empty"] = curve.empty();
  json["images"] = score.images.size();
  json["drawings"] = score.drawings;
  json["tolerance_px"] = question.tolerance_px ? Json(*question.tolerance_px) : Json();
  json["tolerance"] = tolerance_text(question);
  json["prediction"] = {{"path", question.predictions}, {"inverted", score.prediction_inverted}};
  json["reference"] = {{"path", question.references}, {"inverted", score.reference_inverted}};
  json["notes"] = score.notes;
  json["at_ods"] = at_threshold(curve.best(), curve.pooled()[curve.best()]);
  json["at_ois"] = json_of(curve.at_own_best());
  for (int i = 0; i < kThresholds; ++i) json["curve"].push_back(at_threshold(i, curve.pooled()[i]));
  for (const ImageScore& image : score.images) {
    Json entry{{"name", image.name}};
    entry.update(at_threshold(image.threshold, image.counts));
    json["by_image"].push_back(std::move(entry));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string score_table(const CurveQuestion& question, const CurveScore& score) {
  const StrengthCurve& curve = score.curve;
  const StrengthCounts &at_ods = curve.pooled()[curve.best()], &at_ois = curve.at_own_best();
  std::string text = fmt::format("{} against {}: {}, {}, tolerance {}\n", question.predictions,
                                 question.references, counted(score.images.size(), "image", "images"),
                                 counted(static_cast<uint64_t>(score.drawings), "drawing", "drawings"),
                                 tolerance_text(question));
  if (curve.empty()) text += "empty: no line on either side\n";
  text +=
      fmt::format("ods  {:.4f}  F at the best threshold for all, {:.2f}: precision {:.4f}, recall {:.4f}\n",
                  curve.ods(), threshold_of(curve.best()), precision_of(at_ods), recall_of(at_ods));
  text += fmt::format("ois  {:.4f}  F with each image at its own best: precision {:.4f}, recall {:.4f}\n",
                      curve.ois(), precision_of(at_ois), recall_of(at_ois));
  text += curve.ap() ? fmt::format("ap   {:.4f}  mean precision over recalls 0 to 1\n", *curve.ap())
                     : std::string("ap   none    without references there is no recall\n");
  return text;
}

void write_score_files(const fs::path& folder, const CurveQuestion& question, const CurveScore& score) {
  make_folder(folder);
  write_file_atomically(folder / "score.json", score_json(question, score) + "\n");
  write_file_atomically(folder / "curve.csv", curve_csv(score.curve.pooled()));
  write_file_atomically(folder / "images.csv", images_csv(score));
  const StrengthChart chart = chart_of(question, score);
  draw_chart(strength_chart_script(chart), chart_files(folder, chart.name, chart.title));
}

}  // namespace inkbench
