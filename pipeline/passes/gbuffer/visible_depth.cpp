// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/visible_depth.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/gbuffer/quantise.h"
#include "pipeline/passes/gbuffer/visible_range.h"

namespace inkbench {
namespace {

constexpr BufferInfo kVisibleDepth{
    .name = "visible_depth",
    .help =
        "Depth from the nearest visible surface, 0, to the farthest, 1, affine "
        "in the image on planes."};

}  // namespace

constinit const BufferName BufferName::visible_depth{kVisibleDepth};

const PassKind& VisibleDepthPass::kind() {
  static const PassKind kKind =
      describe_pass<VisibleDepthPass>("visible_depth", 2, {shows(BufferName::visible_depth)}, LensInput{},
                                      value_of<QuantisePass>(), value_of<VisibleRangePass>());
  return kKind;
}

VisibleDepthPass::VisibleDepthPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "visible_depth.frag",
               {.samplers = {"normal_and_depth_map", "visible_range_map"}, .uniform_blocks = {kLensBlock}},
               generated) {}

Texture VisibleDepthPass::run(const LensBlock& lens, const Texture& normal_and_depth,
                              const Texture& visible_range) const {
  Texture depth("visible depth", TextureFormat::r32f, normal_and_depth.width_px(),
                normal_and_depth.height_px());
  const RenderTarget target({&depth}, nullptr);
  const Buffer lens_uniforms = lens_buffer(lens);
  program_.use();
  bind_uniform_blocks({&lens_uniforms});
  bind_textures({&normal_and_depth, &visible_range});
  draw_full_screen();
  return depth;
}

}  // namespace inkbench
