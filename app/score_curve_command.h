// SPDX-License-Identifier: MIT
// `inkbench score --curve`: strength maps against drawings, over all thresholds.
#pragma once

#include <optional>
#include <string>

#include "pipeline/line_file.h"

namespace inkbench {

struct ScoreCurveOptions {
  std::string predictions, references;  ///< Images or folders.
  std::string out;                      ///< A folder for files; "": none.
  std::optional<double> tolerance_px;   ///< 0 to 100.
  Invert invert = Invert::automatic;
  bool json = false;
};

/// Prints what came out. Errors: as `pair_images`, `score_curve` and `write_score_files`. Throws `Stopped`.
void print_curve_score(const ScoreCurveOptions& options);

}  // namespace inkbench
