// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/stroke_colours.h"

#include <algorithm>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/passes/edges/detection_pass.h"
#include "pipeline/passes/gbuffer/albedo.h"
#include "pipeline/passes/light/shade.h"
#include "pipeline/passes/placing/tiles.h"
#include "pipeline/passes/strokes/stroke_paint.h"

namespace inkbench {
namespace {

constexpr BufferInfo kStrokes{.name = "strokes",
                              .help = "Curves as the stroke style draws them, over white.",
                              .channels = 4,
                              .shown_as = ShownAs::colour,
                              .is_supersampled = true};

/// stroke_look_block of shaders/lib/stroke_look.glsl in std140.
struct StrokeLookBlock {
  glm::vec4 of_class[kCurveClasses];
  float darken;
  float reach_px;
  float padding[2];
};
const UniformBlock kStrokeLookBlock{"stroke_look_block", sizeof(StrokeLookBlock)};

const ProgramInputs kOwnInputs{.samplers = {"first_classes", "next_classes", "last_classes", "tile_map"},
                               .uniform_blocks = {kStrokeLookBlock, kSquaresBlock}};
const ProgramInputs kSurfaceInputs{.samplers = {"first_classes", "next_classes", "last_classes", "colour_map",
                                                "normal_and_depth_map", "object_id_map", "tile_map"},
                                   .uniform_blocks = {kStrokeLookBlock, kSquaresBlock}};

StrokeLookBlock block_of(const StrokeLook& look) {
  StrokeLookBlock block{};
  for (size_t i = 0; i < kCurveClasses; ++i) {
    const glm::vec4& own = look.of_class[i];
    block.of_class[i] = look.colour == StrokeColour::by_class ? own : glm::vec4(look.ink, own.w);
  }
  block.darken = look.darken;
  return block;
}

bool is_of_material(const Settings& settings) {
  return settings.stroke.colour == StrokeColour::material;
}
bool is_of_shading(const Settings& settings) {
  return settings.stroke.colour == StrokeColour::shading;
}
bool is_of_surface(const Settings& settings) {
  return is_of_material(settings) || is_of_shading(settings);
}

struct StrokeLookInput {
  StrokeLookInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() {
    return {{StrokeParams::description().group}, {InkParams::description().group}};
  }
  StrokeLook get(const FrameState& frame) const {
    const Settings& settings = frame.settings;
    const bool by_class = settings.stroke.colour == StrokeColour::by_class;
    const glm::vec3 none(0.0F);
    StrokeLook look{.colour = settings.stroke.colour,
                    .darken = is_of_surface(settings) ? settings.stroke.darken : 0.0F,
                    .ink = settings.stroke.colour == StrokeColour::ink ? settings.ink.colour : none};
    for (size_t i = 0; i < kCurveClasses; ++i) {
      const StrokeClassParams& params = settings.stroke_classes[i];
      look.of_class[i] = {by_class ? params.colour : none, params.opacity * settings.stroke.opacity};
    }
    return look;
  }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const StrokeLook look = get(frame);
    const StrokeLookBlock block = block_of(look);
    key.add_bytes({reinterpret_cast<const uint8_t*>(&block), sizeof block});
  }
};

}  // namespace

float surface_reach_px(float widest_px) {
  return std::clamp(0.5F * widest_px + 1.0F, 4.0F, static_cast<float>(kMostColourReachPx));
}

constinit const BufferName BufferName::strokes{kStrokes};

const PassKind& StrokeColours::kind() {
  static const PassKind kKind = describe_pass<StrokeColours>(
      "stroke_colours", 2, {shows(BufferName::strokes)}, StrokeLookInput{}, value_of<StrokePaint>(),
      value_when<AlbedoPass, is_of_material>(), value_when<ShadePass, is_of_shading>(),
      value_when<GBufferPass, is_of_surface>());
  return kKind;
}

StrokeColoursPass::StrokeColoursPass(const GeneratedSources& generated)
    : in_one_("tiles.vert", "stroke_colours.frag", kOwnInputs, generated),
      by_class_("tiles.vert", "stroke_colours_by_class.frag", kOwnInputs, generated),
      of_surface_("tiles.vert", "stroke_colours_of_surface.frag", kSurfaceInputs, generated) {}

Texture StrokeColoursPass::run(const StrokeLook& look, const StrokeChannels& channels, const Texture* albedo,
                               const Texture* shaded, const GBuffer* gbuffer) const {
  const auto& [first, next, last] = channels.classes;
  Texture colours("stroke colours", TextureFormat::rgba32f, first.width_px(), first.height_px());
  constexpr glm::vec4 kNoStroke(1.0F, 1.0F, 1.0F, 0.0F);
  StrokeLookBlock block = block_of(look);
  block.reach_px = surface_reach_px(channels.widest_px);
  const Buffer uniforms = uniform_buffer("stroke look block", block);
  const Texture* surface = albedo != nullptr ? albedo : shaded;
  if (surface == nullptr || gbuffer == nullptr)
    draw_over_tiles(colours, look.colour == StrokeColour::by_class ? by_class_ : in_one_, 0,
                    {&first, &next, &last, &channels.tiles}, {&uniforms}, kNoStroke);
  else
    draw_over_tiles(
        colours, of_surface_, 0,
        {&first, &next, &last, surface, &gbuffer->normal_and_depth, &gbuffer->object_id, &channels.tiles},
        {&uniforms}, kNoStroke);
  return colours;
}

}  // namespace inkbench
