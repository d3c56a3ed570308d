// SPDX-License-Identifier: MIT
// Causes of the false and missed lines of a frame: draws again with one thing changed at a time. In: a
// pipeline that nobody needs the last drawing of, and settings. Out: causes by pixel.
#pragma once

#include <functional>
#include <vector>

#include "pipeline/pipeline.h"
#include "studies/measures/causes.h"

namespace inkbench {

/// What is found out one after the other, so that a window can do a step a frame.
class CauseFinder {
 public:
  /// `pipeline` must outlive it. Errors: as `Frame::raw`.
  CauseFinder(Pipeline& pipeline, const Settings& settings);

  /// Draws one of the variants. Returns whether any are left. Errors: as `Frame::raw`.
  bool step();

  /// After the last step.
  CauseMaps causes() const { return find_causes(evidence_); }

 private:
  LineMap lines_of(const Settings& settings);
  void judge_drawing();
  void plan();

  Pipeline& pipeline_;
  Settings settings_;
  CauseEvidence evidence_;
  std::vector<std::function<void()>> steps_;
};

/// All steps at once.
CauseMaps find_causes(Pipeline& pipeline, const Settings& settings);

/// H x W: whether the pixels within `reach_px` of a pixel lie within a pixel's size (in the world) of its
/// plane, which is that of the flatter one of both differences each way. `depth`: share of far, H x W x 1.
LineMap even_pixels(const Image& depth, const CameraParams& camera, int reach_px);

}  // namespace inkbench
