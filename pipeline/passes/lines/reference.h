// SPDX-License-Identifier: MIT
// Reference lines: the lines in object space that a perfect edge filter would draw, as a pass. In: the
// meshes, the G-buffer. Out: the visible lines by class.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/lines/line_finder.h"

namespace inkbench {

class ReferencePass {
 public:
  using Value = ReferenceLines;
  static const PassKind& kind();
  explicit ReferencePass(Flow& flow) : finder_(flow.sharing<LineFinder>()) {}
  /// The visible lines of the scene as it is drawn, its mesh level included; creases and tier 2 are those of
  /// the full mesh.
  ReferenceLines run(const LineRequest& request) const { return finder_->find(request); }

  /// What `run` is given, as plain data for finding the lines on another thread. Errors: as the G-buffer's.
  static LineRequest request(Flow& flow, const FrameState& frame);

 private:
  std::shared_ptr<LineFinder> finder_;
};

}  // namespace inkbench
