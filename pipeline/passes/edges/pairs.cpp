// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/pairs.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/quantise.h"

namespace inkbench {
namespace {

constexpr BufferInfo kPairAngles{.name = "pair_angles",
                                 .help =
                                     "Degrees between a pixel's surface and that on its right and above "
                                     "it; below 0 where the line would be theirs.",
                                 .channels = 2,
                                 .gain = &DisplayParams::pair_angles_gain};
constexpr BufferInfo kPairGaps{.name = "pair_gaps",
                               .help =
                                   "How far a pixel and those on its right and above it are from each "
                                   "other's planes, in pixels' sizes; below 0 where the line would be "
                                   "theirs.",
                               .first_channel = 2,
                               .channels = 2};

/// pairs_block of shaders/pairs.frag in std140.
struct PairsBlock {
  int reads_shading;  ///< Whether the normals that light sees count.
  int reads_surface;  ///< Whether the triangles' do.
  int padding[2];
};

}  // namespace

constinit const BufferName BufferName::pair_angles{kPairAngles};
constinit const BufferName BufferName::pair_gaps{kPairGaps};

const PassKind& PairsPass::kind() {
  static const PassKind kKind =
      describe_pass<PairsPass>("pairs", 5, {shows(BufferName::pair_angles), shows(BufferName::pair_gaps)},
                               part<&Settings::dihedral, &DihedralParams::normals>(), LensInput{},
                               value_of<QuantisePass>(), value_of<GBufferPass>());
  return kKind;
}

PairsPass::PairsPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "pairs.frag",
               {.samplers = {"surface_map", "normal_and_depth_map"},
                .uniform_blocks = {kLensBlock, {"pairs_block", sizeof(PairsBlock)}}},
               generated) {}

Texture PairsPass::run(BendNormals normals, const LensBlock& lens, const Texture& normal_and_depth,
                       const GBuffer& gbuffer) const {
  Texture pairs("pairs", TextureFormat::rgba16f, normal_and_depth.width_px(), normal_and_depth.height_px());
  const PairsBlock block{
      normals != BendNormals::surface ? 1 : 0, normals != BendNormals::shading ? 1 : 0, {}};
  const Buffer uniforms("pairs block", bytes_of(std::span(&block, 1))), lens_uniforms = lens_buffer(lens);
  draw_over(pairs, program_, {&gbuffer.surface, &normal_and_depth}, {&lens_uniforms, &uniforms});
  return pairs;
}

}  // namespace inkbench
