// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/gradient.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/gbuffer/quantise.h"

namespace inkbench {
namespace {

constexpr BufferInfo kNormalEdges{.name = "normal_edges",
                                  .help = "How much the normals change around each pixel.",
                                  .number_key = 3,
                                  .first_channel = 1,
                                  .gain = &DisplayParams::normal_edges_gain};
constexpr BufferInfo kDepthEdges{.name = "depth_edges",
                                 .help = "How much the depth changes around each pixel.",
                                 .number_key = 4,
                                 .gain = &DisplayParams::depth_edges_gain};

}  // namespace

constinit const BufferName BufferName::normal_edges{kNormalEdges};
constinit const BufferName BufferName::depth_edges{kDepthEdges};

const PassKind& GradientPass::kind() {
  static const PassKind kKind = describe_pass<GradientPass>(
      "gradient", 10, {shows(BufferName::normal_edges), shows(BufferName::depth_edges)},
      value_of<QuantisePass>(), part<&Settings::image, &ImageParams::precision>());
  return kKind;
}

GradientPass::GradientPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "gradient.frag", {.samplers = {"normal_and_depth_map"}}, generated) {}

Texture GradientPass::run(const Texture& normal_and_depth, Precision precision) const {
  const TextureFormat format = precision == Precision::unorm8 ? TextureFormat::rg8 : TextureFormat::rg32f;
  Texture gradient("gradient", format, normal_and_depth.width_px(), normal_and_depth.height_px());
  const RenderTarget target({&gradient}, nullptr);
  program_.use();
  bind_textures({&normal_and_depth});
  draw_full_screen();
  return gradient;
}

}  // namespace inkbench
