// SPDX-License-Identifier: MIT
// The strokes of a view, as a pass. In: its curves, the style, what widths follow, the frame before. Out:
// strokes as plain data, which are drawn and written as vectors.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"
#include "pipeline/strokes/make_strokes.h"

namespace inkbench {

/// What of a style decides where strokes lie and how wide they are; what is paint alone is as it is by
/// default.
struct StrokeCourseParams {
  StrokeParams stroke;
  StrokeClasses classes;
  int height_px = 0;  ///< Of the whole image.
  LensBlock lens{};
};
StrokeCourseParams stroke_course(const Settings& settings);

/// Is anything drawn by strokes over the shading?
bool draws_strokes(const Settings& settings);
/// Does the filter of `edges.method` draw over the shading?
bool draws_filter(const Settings& settings);

class StrokesPass {
 public:
  using Value = Strokes;
  static const PassKind& kind();
  /// `visible`: nearest and farthest distance, where widths follow them; `shaded` and `gbuffer` where they
  /// follow the light; `before`: of the frame before, null where there is none. Errors (input):
  /// `stroke.profile` is none.
  Strokes run(const Curves& curves, const StrokeCourseParams& params, const Texture* visible,
              const Texture* shaded, const GBuffer* gbuffer, const Strokes* before) const;
};

/// The same strokes in an image of so many times the size.
Strokes enlarged(const Strokes& strokes, int times);

}  // namespace inkbench
