// SPDX-License-Identifier: MIT
// Motion: how far each pixel's surface point is from where it stood in the frame before. In: depth and ids of
// this frame; camera and models of both. Out: a map of offsets; which lines flicker is read from it.
#pragma once

#include <optional>
#include <span>

#include "pipeline/gl/program.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/meshes.h"

namespace inkbench {

/// What is where in one frame.
struct FramePlaces {
  CameraParams camera;
  int width_px = 0, height_px = 0;
  DrawItems drawn;
};
struct MotionPlaces {
  FramePlaces here;
  std::optional<FramePlaces> before;  ///< None for a frame without a past.
};

/// To look ahead, hand a frame the one after it as its past: the motion is to whichever it was given.
class MotionPass {
 public:
  /// rgba32f. Red, green: px to the right and down, from the pixel to where its surface point is in the frame
  /// before. Blue: the distance along the view axis there, world units. Alpha: 1; all four are 0 where no
  /// model is, without a frame before, and where the point is not between its planes or its model has
  /// another mesh or is not shown.
  using Value = Texture;
  static const PassKind& kind();
  explicit MotionPass(const GeneratedSources& generated);
  Texture run(const MotionPlaces& places, const GBuffer& gbuffer) const;
  const Program& program() const { return program_; }
  Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace inkbench
