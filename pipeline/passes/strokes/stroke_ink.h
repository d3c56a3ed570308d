// SPDX-License-Identifier: MIT
// Strokes as ink: what is measured of them, in the way in which the filter's lines are
// (shaders/lib/ink.glsl).
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/passes/strokes/stroke_draw.h"
#include "pipeline/settings/line_params.h"

namespace inkbench {

/// As what a curve's line is measured: boundaries as silhouettes, intersections as creases, lines of the
/// smooth surface as `normal`.
EdgeClass edge_class_of(CurveClass curve_class);

class StrokeInkPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  explicit StrokeInkPass(const GeneratedSources& generated);
  /// Out: rg8: the largest coverage, paint's gaps left out; EdgeClass / 255 of the class that has it (the
  /// first of several), 0 where there is no ink. Opacity is not coverage.
  Texture run(const StrokeChannels& channels) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
