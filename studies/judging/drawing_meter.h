// SPDX-License-Identifier: MIT
// Settings to a tally: draws, finds the reference lines, and counts. In: settings, or those of several views.
// Out: the tally of the drawing, whose counts all views add to before any ratio is taken. What studies and
// the command line measure with; the window hands the same `tally_view` what it has drawn already.
#pragma once

#include <map>
#include <optional>
#include <span>

#include "pipeline/pipeline.h"
#include "studies/judging/flicker_meter.h"
#include "studies/judging/measured_lines.h"

namespace inkbench {

class DrawingMeter {
 public:
  /// `pipeline` must outlive it.
  DrawingMeter(Pipeline& pipeline, const MeasureNeeds& needs)
      : pipeline_(pipeline), needs_(needs), flicker_(pipeline, needs) {}

  /// Of one view, judged as its settings say; along a camera path also of what came and went since the frame
  /// before. Errors: as `Frame::raw`.
  DrawingTally tally(const Frame& frame, const Frame* before = nullptr);

  /// Of all views together.
  DrawingTally tally(std::span<const Settings> views);

  /// Of the view that was tallied last; none where the needs do not ask for causes.
  const std::optional<CauseMaps>& last_causes() const { return last_causes_; }

  /// Of all that decides what `tally` gives for this view but its code.
  Key key(const Frame& frame, const Frame* before = nullptr);

 private:
  Frame with_full_mesh(const Frame& frame);
  LineView full_view(const Frame& full);

  Pipeline& pipeline_;
  MeasureNeeds needs_;
  FlickerMeter flicker_;
  std::optional<CauseMaps> last_causes_;
  std::map<Key, LineView> full_lines_;    ///< The full mesh's lines in each view; `drawn` is left empty.
  std::map<Key, LineMap> full_drawings_;  ///< And its drawings, for all k's that a sweep comes back to.
};

/// The triangles of the main model as drawn; 0 without one.
size_t drawn_faces(MeshStore& meshes, const Settings& settings);

/// How much of each pixel the drawn picture covers with ink, 0 to 1, H x W x 1: of pictures at the settings'
/// size whatever they are drawn at. Of a method that places lines. Errors: as `Frame::picture`.
Image drawn_coverage(const Frame& frame);

}  // namespace inkbench
