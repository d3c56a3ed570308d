// SPDX-License-Identifier: MIT
// Curves to look at: thin lines in their classes' colours. In: a view's curves. Out: a picture over white;
// covered ones are fainter and dashed, and there only when strokes of them are drawn.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/passes/strokes/stroke_colours.h"
#include "pipeline/passes/strokes/stroke_draw.h"

namespace inkbench {

/// The curves as strokes of one width.
class CurveLinesPass {
 public:
  using Value = Strokes;
  static const PassKind& kind();
  Strokes run(const Curves& curves, bool with_hidden) const;
};

struct CurvePaint {
  using Value = StrokeChannels;
  using Pass = StrokeDrawPass;
  static const PassKind& kind();
};

/// As `StrokeColours`.
struct CurveColours {
  using Value = Texture;
  using Pass = StrokeColoursPass;
  static const PassKind& kind();
};

}  // namespace inkbench
