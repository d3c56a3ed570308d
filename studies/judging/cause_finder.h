// SPDX-License-Identifier: MIT
// Causes of the false and missed lines of a frame: draws again with one thing changed at a time. In: a
// pipeline that nobody needs the last drawing of, and settings. Out: causes by pixel.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "pipeline/pipeline.h"
#include "studies/measures/causes.h"

namespace inkbench {

/// Gives the request's lines, or null where they are still being found: it is asked again then.
using FindLines = std::function<std::shared_ptr<const ReferenceLines>(const LineRequest&)>;

/// What is found out one after the other, so that a window can do a step a frame.
class CauseFinder {
 public:
  /// `pipeline` must outlive it. Without `find_lines` its line finder is waited for. Errors: as `Frame::raw`;
  /// (input) twice the image's size is more than can be drawn.
  CauseFinder(Pipeline& pipeline, const Settings& settings, FindLines find_lines = {});

  /// Judges the drawing first, then draws one of the variants in each step. Returns whether any are left.
  /// Errors: as `Frame::raw`.
  bool step();

  /// What is right and wrong, after the first step; null while its lines are being found.
  const MatchMaps* maps() const { return is_judged_ ? &evidence_.maps : nullptr; }
  /// After the last step.
  CauseMaps causes() const { return find_causes(evidence_); }

 private:
  using Lines = std::optional<LineMap> CauseEvidence::*;
  void plan();
  void plan_facets();
  void add(Lines map, const Settings& settings);
  bool judge_drawing();
  bool find_slight_bends();
  std::shared_ptr<const ReferenceLines> find(const std::function<LineRequest()>& make);

  Pipeline& pipeline_;
  Settings settings_;
  FindLines find_lines_;
  CauseEvidence evidence_;
  bool is_judged_ = false;
  std::optional<LineRequest> asked_;         ///< Its lines are being found.
  std::deque<std::function<bool()>> steps_;  ///< Each says whether it is done.
};

/// All steps at once.
CauseMaps find_causes(Pipeline& pipeline, const Settings& settings);

/// The cause of the pixel, or of the nearest one within the judge's tolerance; nothing where none of them is
/// false or missed, which is found out first.
std::optional<PixelCause> find_cause(Pipeline& pipeline, const Settings& settings, int x, int y);

/// Of all that decides the causes: other sizes and normals follow from the settings themselves.
Key causes_key(const Frame& frame);

/// H x W: whether the pixels within `reach_px` of a pixel lie within its size (in the world) of its plane,
/// which follows the flatter one of both differences each way. `depth`: share of far, H x W x 1; the
/// background lies in no plane.
LineMap even_pixels(const Image& depth, const CameraParams& camera, int reach_px);

}  // namespace inkbench
