// SPDX-License-Identifier: MIT
// Two frames of a camera path to the counts of their flicker. In: the frame before and the frame now. Out:
// what died and was born between them, of the drawn lines and of the reference lines.
#pragma once

#include <optional>

#include "pipeline/pipeline.h"
#include "studies/measures/measures.h"

namespace inkbench {

class FlickerMeter {
 public:
  /// `pipeline` must outlive it.
  FlickerMeter(Pipeline& pipeline, const MeasureNeeds& needs) : pipeline_(pipeline), needs_(needs) {}

  /// The first frame of a path, which is kept for when it is the frame before.
  void start(const Frame& first) { last_ = seen(first); }

  /// Judged as the settings of `now` say. What is seen `now` is kept for when it is the frame before. Errors
  /// (input): the frames have two sizes; as `Frame::raw`.
  FlickerTally tally(const Frame& before, const Frame& now);

  /// Of all that decides what `tally` gives but its code.
  Key key(const Frame& before, const Frame& now);

 private:
  /// A frame's lines as they count, and its depth.
  struct Seen {
    Key key;
    LineMap drawn, wanted;
    Image depth;
    CameraParams camera;
  };
  Key seen_key(const Frame& frame) const;
  Seen seen(const Frame& frame) const;

  Pipeline& pipeline_;
  MeasureNeeds needs_;
  std::optional<Seen> last_;
};

}  // namespace inkbench
