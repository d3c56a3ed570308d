// SPDX-License-Identifier: MIT
// Precision and recall over thresholds for a set of images. In: pairs of files. Out: the pooled curve, each
// image at its own best, and what was decided on the way. Memory does not grow with the number of images.
#pragma once

#include <functional>

#include "pipeline/line_file.h"
#include "studies/measures/strength_curve.h"
#include "studies/scoring/image_pairs.h"

namespace inkbench {

struct CurveScoreOptions {
  std::optional<double> tolerance_px;  ///< 0.0075 x each image's diagonal without it.
  Invert invert = Invert::automatic;   ///< Of each side: once, over all of its files.
  /// Images done, and all; from any thread, one at a time.
  std::function<void(size_t, size_t)> on_progress;
};

struct ImageScore {
  std::string name;
  int threshold = 0;      ///< The number of its own best one.
  StrengthCounts counts;  ///< There.
};

struct CurveScore {
  StrengthCurve curve;
  std::vector<ImageScore> images;  ///< In the pairs' order.
  bool prediction_inverted = false, reference_inverted = false;
  int drawings = 0;                ///< Of all images.
  std::vector<std::string> notes;  ///< What a person should know.
};

/// Reads all files twice: what is wrong with one is said before anything is counted. Errors (input): as
/// `survey_strengths` and `survey_drawings`; a drawing of another size than its prediction. (Work): memory.
/// Throws `Stopped`.
CurveScore score_curve(const ImagePairs& pairs, const CurveScoreOptions& options = {});

}  // namespace inkbench
