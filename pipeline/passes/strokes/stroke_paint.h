// SPDX-License-Identifier: MIT
// The strokes of a view as they are painted: the node of `StrokeDrawPass`.
#pragma once

#include "pipeline/passes/strokes/stroke_draw.h"

namespace inkbench {

struct StrokePaint {
  using Value = StrokeChannels;
  using Pass = StrokeDrawPass;
  static const PassKind& kind();
};

}  // namespace inkbench
