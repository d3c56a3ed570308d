// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/strokes_over.h"

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/ink.h"
#include "pipeline/passes/ink/under_ink.h"
#include "pipeline/passes/strokes/stroke_colours.h"

namespace inkbench {
namespace {

constexpr BufferInfo kFinal{.name = "final",
                            .help = "Ink over the shading.",
                            .number_key = 7,
                            .channels = 3,
                            .shown_as = ShownAs::colour,
                            .is_supersampled = true};

}  // namespace

constinit const BufferName BufferName::final{kFinal};

const PassKind& BelowStrokes::kind() {
  static const PassKind kKind =
      describe_choice<BelowStrokes, UnderInk, InkPass>("below_strokes", InkParams::description().group, {});
  return kKind;
}

const PassKind& StrokesOverPass::kind() {
  static const PassKind kKind = describe_pass<StrokesOverPass>(
      "strokes_over", 1, {}, value_of<BelowStrokes>(), value_of<StrokeColours>());
  return kKind;
}

const PassKind& FinalImage::kind() {
  static const PassKind kKind = describe_choice<FinalImage, InkPass, StrokesOverPass>(
      "final", InkParams::description().group, {shows(BufferName::final)});
  return kKind;
}

StrokesOverPass::StrokesOverPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "strokes_over.frag", {.samplers = {"below_map", "stroke_map"}},
               generated) {}

Texture StrokesOverPass::run(const Texture& below, const Texture& strokes) const {
  Texture final("strokes over", TextureFormat::rgba32f, below.width_px(), below.height_px());
  draw_over(final, program_, {&below, &strokes}, {});
  return final;
}

}  // namespace inkbench
