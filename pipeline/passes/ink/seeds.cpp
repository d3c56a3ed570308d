// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/seeds.h"

#include <algorithm>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/visible_range.h"
#include "pipeline/passes/placing/connect.h"

namespace inkbench {
namespace {

/// widths_block of shaders/lib/line_width.glsl in std140.
struct WidthsBlock {
  float of_class[8];
  float height_px;
  float padding[3];
};

}  // namespace

WidthParams widths_of(const Settings& settings) {
  WidthParams widths{settings.line, {}};
  for (size_t i = 0; i < kEdgeClasses; ++i) widths.of_class[i] = settings.class_looks[i].width;
  // What is no width.
  widths.line.taper = 0;
  widths.line.antialias = true;
  widths.line.colour_by_class = false;
  return widths;
}

bool widths_need_range(const Settings& settings) {
  return settings.line.unit == WidthUnit::world || settings.line.depth_taper > 0;
}

void WidthInput::fold(KeyBuilder& key, const FrameState& frame) const {
  const WidthParams widths = get(frame);
  key.add(group_text(widths.line));
  key.add_bytes({reinterpret_cast<const uint8_t*>(widths.of_class.data()), sizeof widths.of_class});
}

float widest_half_px(const WidthParams& widths, const LensBlock& lens, int height_px,
                     const Texture* visible) {
  float width = widths.line.width;
  if (widths.line.unit == WidthUnit::percent) width *= static_cast<float>(height_px) / 100.0F;
  if (widths.line.unit == WidthUnit::world) {
    const Image range = visible->read(0, 2);
    if (range.at(0, 0, 0) > range.at(0, 0, 1)) return 0.0F;
    width /= lens.is_orthographic != 0 ? lens.pixel_size : lens.pixel_size * range.at(0, 0, 0);
  }
  return 0.5F * width * *std::max_element(widths.of_class.begin(), widths.of_class.end());
}

const PassKind& SeedsPass::kind() {
  static const PassKind kKind =
      describe_pass<SeedsPass>("seeds", 2, {}, WidthInput{}, LensInput{}, value_of<ConnectPass>(),
                               value_of<GBufferPass>(), value_when<VisibleRangePass, widths_need_range>());
  return kKind;
}

SeedsPass::SeedsPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "seeds.frag",
               {.samplers = {"placed_map", "normal_and_depth_map", "visible_map"},
                .uniform_blocks = {block_of(LineParams::description()),
                                   kLensBlock,
                                   {"widths_block", sizeof(WidthsBlock)}}},
               generated) {}

Texture SeedsPass::run(const WidthParams& widths, const LensBlock& lens, const Texture& placed,
                       const GBuffer& gbuffer, const Texture* visible) const {
  Texture seeds("seeds", TextureFormat::rgba32f, placed.width_px(), placed.height_px());
  WidthsBlock block{};
  std::copy(widths.of_class.begin(), widths.of_class.end(), block.of_class);
  block.height_px = static_cast<float>(placed.height_px());
  const Buffer line = block_buffer(widths.line), lens_uniforms = lens_buffer(lens);
  const Buffer factors("widths block", bytes_of(std::span<const WidthsBlock>(&block, 1)));
  const Texture& range = visible != nullptr ? *visible : placed;  // not looked at
  draw_over(seeds, program_, {&placed, &gbuffer.normal_and_depth, &range}, {&line, &lens_uniforms, &factors});
  return seeds;
}

}  // namespace inkbench
