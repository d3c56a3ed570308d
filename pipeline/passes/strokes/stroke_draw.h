// SPDX-License-Identifier: MIT
// Strokes drawn by OpenGL. In: strokes, the brush. Out: for each class of curves how much of each pixel its
// paint covers; joins, caps and crossings show nothing of what lies below them.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "pipeline/flow/flow.h"
#include "pipeline/gl/program.h"
#include "pipeline/settings/stroke_params.h"
#include "pipeline/strokes/stroke.h"

namespace inkbench {

/// Each an rgba8 texture of four classes in their order, H x W: the largest coverage of the class's strokes,
/// 0 to 1, covered ones times `stroke.hidden_opacity`.
struct StrokeChannels {
  std::array<Texture, 3> classes;
  Texture tiles;           ///< r8, a texel for 8 x 8 pixels: 1 where strokes may be (stroke_tiles.h).
  float widest_px = 0.0F;  ///< Width of the widest stroke.
};

/// What of a style is paint.
struct BrushParams {
  Brush brush = Brush::solid;
  std::string image;  ///< A file.
  float length_px = 64.0F;
  BrushFit fit = BrushFit::tile;
  float grain = 0.5F;
  float hidden_opacity = 1.0F;
};
BrushParams brush_of(const StrokeParams& params);

class StrokeDrawPass {
 public:
  explicit StrokeDrawPass(const GeneratedSources& generated);
  /// The part of the image that the window says. Errors (input): the brush's image cannot be read.
  StrokeChannels run(const BrushParams& brush, const ImageWindow& window, const Strokes& strokes) const;
  std::vector<Program*> programs();

 private:
  std::vector<Program> brushes_;  ///< By `Brush`: each pays for its own paint alone.
};

}  // namespace inkbench
