// SPDX-License-Identifier: MIT
// The curves of a view, as a pass.
#pragma once

#include "pipeline/curves/curve.h"
#include "pipeline/flow/flow.h"
#include "pipeline/lines/reference_lines.h"

namespace inkbench {

class CurvesPass {
 public:
  using Value = Curves;
  static const PassKind& kind();
  /// The visible lines of the meshes, without what hides or carries them.
  Curves run(const ReferenceLines& lines) const;
};

}  // namespace inkbench
