// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/ink.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/ink/drawn_ink.h"
#include "pipeline/passes/ink/under_ink.h"

namespace inkbench {
namespace {

/// look_block of shaders/ink_by_class.frag in std140.
struct LookBlock {
  glm::vec4 of_class[kEdgeClasses];
  int has_colours;
  int padding[3];
};

LookBlock block_of(const InkLook& look) {
  LookBlock block{};
  for (size_t i = 0; i < kEdgeClasses; ++i)
    block.of_class[i] = glm::vec4(look.of_class[i].colour, look.of_class[i].opacity);
  block.has_colours = look.has_colours ? 1 : 0;
  return block;
}

struct InkLookInput {
  InkLookInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() {
    return {{InkParams::description().group}, {LineParams::description().group}};
  }
  InkLook get(const FrameState& frame) const {
    const Settings& settings = frame.settings;
    return {{.colour = settings.ink.colour},
            is_papers_ink(settings),
            settings.line.colour_by_class,
            settings.class_looks};
  }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const InkLook look = get(frame);
    key.add(group_text(look.ink));
    if (look.is_papers) return;
    for (ClassLookParams params : look.of_class) {
      params.width = 0;  // decides where the ink is
      if (!look.has_colours) params.colour = look.ink.colour;
      key.add(group_text(params));
    }
  }
};

}  // namespace

const PassKind& InkPass::kind() {
  static const PassKind kKind =
      describe_pass<InkPass>("ink", 1, {}, InkLookInput{}, value_of<UnderInk>(), value_of<FilterInk>());
  return kKind;
}

InkPass::InkPass(const GeneratedSources& generated)
    : papers_("full_screen.vert", "ink.frag",
              {.samplers = {"shaded_map", "drawn_map"},
               .uniform_blocks = {inkbench::block_of(InkParams::description())}},
              generated),
      by_class_("full_screen.vert", "ink_by_class.frag",
                {.samplers = {"shaded_map", "drawn_map"},
                 .uniform_blocks = {inkbench::block_of(InkParams::description()),
                                    {"look_block", sizeof(LookBlock)}}},
                generated) {}

Texture InkPass::run(const InkLook& look, const Texture& shaded, const Texture& drawn) const {
  Texture final("final", TextureFormat::rgba32f, shaded.width_px(), shaded.height_px());
  const Buffer ink = block_buffer(look.ink);
  if (look.is_papers) {
    draw_over(final, papers_, {&shaded, &drawn}, {&ink});
    return final;
  }
  const LookBlock block = block_of(look);
  const Buffer classes = uniform_buffer("look block", block);
  draw_over(final, by_class_, {&shaded, &drawn}, {&ink, &classes});
  return final;
}

}  // namespace inkbench
