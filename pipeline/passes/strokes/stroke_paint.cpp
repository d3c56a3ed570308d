// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/stroke_paint.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/strokes/brush_image.h"
#include "pipeline/passes/strokes/strokes.h"

namespace inkbench {
namespace {

/// Only what the brush reads is in the key. Run with: const BrushParams&.
struct BrushInput {
  BrushInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {{StrokeParams::description().group}}; }
  BrushParams get(const FrameState& frame) const { return brush_of(frame.settings.stroke); }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    StrokeParams read;
    const StrokeParams& stroke = frame.settings.stroke;
    read.brush = stroke.brush;
    read.hidden_opacity = stroke.hidden_opacity;
    if (stroke.brush != Brush::solid) {
      read.brush_length = stroke.brush_length;
      read.brush_fit = stroke.brush_fit;
      read.grain = stroke.grain;
    }
    if (stroke.brush == Brush::image) key.add(brush_image_key(stroke.brush_image));
    key.add(group_text(read));
  }
};

}  // namespace

const PassKind& StrokePaint::kind() {
  static const PassKind kKind =
      describe_pass<StrokePaint>("stroke_paint", 5, {}, BrushInput{}, WindowInput{}, value_of<StrokesPass>());
  return kKind;
}

}  // namespace inkbench
