// SPDX-License-Identifier: MIT
// A cell's views as frames. In: a spec, the place of a view. Out: the frame, along a camera path with the
// frames before it as its past.
#pragma once

#include <optional>

#include "pipeline/pipeline.h"
#include "studies/sweep/spec.h"

namespace inkbench {

struct ViewFrame {
  Frame frame;
  std::optional<Frame> before;  ///< The path's frame before; none for its first, and without a path.
  const Frame* past() const { return before ? &*before : nullptr; }
};

class ViewFrames {
 public:
  /// Both must outlive it.
  ViewFrames(Pipeline& pipeline, const StudySpec& spec) : pipeline_(pipeline), spec_(spec) {}

  /// Quickest for one view after the other. Errors (input): a mesh or ramp cannot be read.
  ViewFrame at(const Cell& cell, size_t view);

 private:
  Pipeline& pipeline_;
  const StudySpec& spec_;
  std::optional<ViewFrame> last_;  ///< Along a path.
  size_t last_cell_ = 0, last_view_ = 0;
};

}  // namespace inkbench
