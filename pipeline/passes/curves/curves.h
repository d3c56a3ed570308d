// SPDX-License-Identifier: MIT
// The curves of a view by `curves.from`: those of the meshes, those traced in the drawn lines, or both.
#pragma once

#include "pipeline/curves/curve.h"
#include "pipeline/flow/flow.h"

namespace inkbench {

class CurvesPass {
 public:
  using Value = Curves;
  static const PassKind& kind();
  /// Null: not asked for. Of both, traced ones come last, in chains of their own, without what runs along a
  /// visible curve of a mesh.
  Curves run(const Curves* of_objects, const Curves* traced) const;
};

}  // namespace inkbench
