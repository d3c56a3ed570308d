// SPDX-License-Identifier: MIT
// The lines that the chosen detector finds, traced into curves. In: placed lines without those that are too
// weak or too short, the G-buffer. Out: curves in the whole image's pixels.
#pragma once

#include "pipeline/curves/curve.h"
#include "pipeline/curves/line_pixels.h"
#include "pipeline/flow/flow.h"
#include "pipeline/flow/image_window.h"
#include "pipeline/passes/gbuffer/gbuffer.h"

namespace inkbench {

/// What is seen around line pixels, of one image: H x W x 1 each.
struct SeenMaps {
  Image depth;      ///< Linear depth / far, 1 where no model is.
  Image object_id;  ///< 0 where no model is.
};

/// Line pixels of packed placed lines (placing/placed_lines.h), as `Texture::read_picture` gives them. Object
/// and depth are those of the nearest of the nine pixels around; behind lies the farthest of the 25 around,
/// since operators look two pixels far. The curve's class is the edge's by name. `far`: of the camera, world
/// units.
LinePixels line_pixels_of(const Picture& placed, const SeenMaps& seen, float far);

class TracedCurvesPass {
 public:
  using Value = Curves;
  static const PassKind& kind();
  /// `reach_px`: as `trace_lines` takes it. Where a part of the image is drawn lines end at the part's
  /// border.
  Curves run(float reach_px, float far, const ImageWindow& window, const Texture& placed,
             const GBuffer& gbuffer) const;
};

}  // namespace inkbench
