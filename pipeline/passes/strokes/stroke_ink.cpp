// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/stroke_ink.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/placing/tiles.h"
#include "pipeline/passes/strokes/stroke_paint.h"

namespace inkbench {
namespace {

/// stroke_ink_block of shaders/stroke_ink.frag in std140.
struct StrokeInkBlock {
  glm::vec4 edge_class[3];
};

}  // namespace

EdgeClass edge_class_of(CurveClass curve_class) {
  switch (curve_class) {
    case CurveClass::silhouette:
    case CurveClass::boundary:
      return EdgeClass::silhouette;
    case CurveClass::object:
      return EdgeClass::object;
    case CurveClass::crease:
    case CurveClass::intersection:
      return EdgeClass::crease;
    case CurveClass::shadow:
      return EdgeClass::shadow;
    case CurveClass::material:
      return EdgeClass::material;
    default:
      return EdgeClass::normal;
  }
}

const PassKind& StrokeInkPass::kind() {
  static const PassKind kKind = describe_pass<StrokeInkPass>("stroke_ink", 1, {}, value_of<StrokePaint>());
  return kKind;
}

StrokeInkPass::StrokeInkPass(const GeneratedSources& generated)
    : program_("tiles.vert", "stroke_ink.frag",
               {.samplers = {"first_classes", "next_classes", "last_classes", "tile_map"},
                .uniform_blocks = {{"stroke_ink_block", sizeof(StrokeInkBlock)}, kSquaresBlock}},
               generated) {}

Texture StrokeInkPass::run(const StrokeChannels& channels) const {
  const auto& [first, next, last] = channels.classes;
  Texture ink("stroke ink", TextureFormat::rg8, first.width_px(), first.height_px());
  StrokeInkBlock block{};
  for (int i = 0; i < static_cast<int>(kCurveClasses); ++i)
    block.edge_class[i / 4][i % 4] = static_cast<float>(edge_class_of(static_cast<CurveClass>(i)));
  const Buffer uniforms = uniform_buffer("stroke ink block", block);
  draw_over_tiles(ink, program_, 0, {&first, &next, &last, &channels.tiles}, {&uniforms});
  return ink;
}

}  // namespace inkbench
