// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/shaded_pairs.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/edges/pairs.h"
#include "pipeline/passes/gbuffer/quantise.h"

namespace inkbench {
namespace {

constexpr BufferInfo kPairAngles{.name = "pair_angles",
                                 .help =
                                     "Degrees between a pixel's surface and that on its right and above "
                                     "it; below 0 where a crease would be theirs. Other methods: 0.",
                                 .channels = 2,
                                 .gain = &DisplayParams::pair_angles_gain,
                                 .matters_when = "edges.method = dihedral"};
constexpr BufferInfo kPairGaps{.name = "pair_gaps",
                               .help =
                                   "How far a pixel and those on its right and above it are off each "
                                   "other's planes, in pixels' sizes; below 0 where a step would be "
                                   "theirs. Other methods: 0.",
                               .first_channel = 2,
                               .channels = 2,
                               .matters_when = "edges.method = dihedral"};

/// shaded_pairs_block of shaders/shaded_pairs.frag in std140.
struct ShadedPairsBlock {
  int keeps_surface;  ///< Whether the triangles' angles count as well.
  int padding[3];
};

}  // namespace

constinit const BufferName BufferName::pair_angles{kPairAngles};
constinit const BufferName BufferName::pair_gaps{kPairGaps};

const PassKind& ShadedPairsPass::kind() {
  static const PassKind kKind = describe_pass<ShadedPairsPass>(
      "shaded_pairs", 4, {shows(BufferName::pair_angles), shows(BufferName::pair_gaps)},
      value_of<PairsPass>(), part<&Settings::dihedral, &DihedralParams::normals>(), value_of<QuantisePass>());
  return kKind;
}

ShadedPairsPass::ShadedPairsPass(const GeneratedSources& generated)
    : program_("full_screen.vert", "shaded_pairs.frag",
               {.samplers = {"pair_map", "normal_and_depth_map"},
                .uniform_blocks = {{"shaded_pairs_block", sizeof(ShadedPairsBlock)}}},
               generated) {}

Texture ShadedPairsPass::run(const Texture& pairs, BendNormals normals,
                             const Texture& normal_and_depth) const {
  Texture shaded("shaded pairs", TextureFormat::rgba16f, pairs.width_px(), pairs.height_px());
  const ShadedPairsBlock block{normals == BendNormals::both ? 1 : 0, {}};
  const Buffer uniforms("shaded pairs block", bytes_of(std::span(&block, 1)));
  draw_over(shaded, program_, {&pairs, &normal_and_depth}, {&uniforms});
  return shaded;
}

}  // namespace inkbench
