// SPDX-License-Identifier: MIT
// A score over thresholds as people and programs take it away. In: the score and what was asked. Out: JSON, a
// table, and a folder of files.
#pragma once

#include "studies/report/drawn_chart.h"
#include "studies/scoring/score_curve.h"

namespace inkbench {

/// What was scored, as it was asked.
struct CurveQuestion {
  std::string predictions, references;  ///< Paths.
  std::optional<double> tolerance_px;
};

/// One JSON object on one line.
std::string score_json(const CurveQuestion& question, const CurveScore& score);

/// A table for people.
std::string score_table(const CurveQuestion& question, const CurveScore& score);

/// Writes score.json, curve.csv, images.csv and curve.gp, .svg and .png into the folder, which is made.
/// Errors (work): as `draw_chart`; full disk. Throws `Stopped`.
void write_score_files(const std::filesystem::path& folder, const CurveQuestion& question,
                       const CurveScore& score);

}  // namespace inkbench
