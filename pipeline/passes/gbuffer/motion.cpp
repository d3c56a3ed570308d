// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/motion.h"

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

constexpr BufferInfo kMotion{.name = "motion",
                             .help =
                                 "Where each point stood in the frame before, in px to the right and down; "
                                 "grey where it did not move or there is none.",
                             .channels = 2,
                             .shown_as = ShownAs::offset,
                             .looks_back = true};

constexpr int kModelsAtOnce = 128;  // motion.frag has the same

/// motion_block of shaders/motion.frag in std140.
struct MotionBlock {
  glm::mat4 projection;
  glm::mat4 other_projection;
  glm::vec2 size_px;
  glm::vec2 other_size_px;
  float far;
  int first_model;
  std::array<float, 2> padding;
};
using ModelMoves = std::array<glm::mat4, kModelsAtOnce>;

struct BoundMotionPlaces {
  static constexpr bool kLooksBack = true;
  Flow* flow = nullptr;
  BoundDrawItems drawn;

  void fold(KeyBuilder& key, const FrameState& frame) const {
    fold_places(key, frame);
    if (frame.previous) {
      fold_places(key, *frame.previous);
    } else {
      key.add("no frame before");
    }
  }
  MotionPlaces get(const FrameState& frame) const {
    if (!frame.previous) return {places(frame), std::nullopt};
    // Whoever carries points one way mostly carries them back, too. This input comes first, so that the
    // G-buffer of the other frame is still there.
    drawn.meshes.node->keep_frames(2);
    flow->node<GBufferPass>().keep_frames(2);
    return {places(frame), places(*frame.previous)};
  }

 private:
  void fold_places(KeyBuilder& key, const FrameState& frame) const {
    const ImageParams& image = frame.settings.image;
    key.add(group_text(frame.settings.camera))
        .add(std::to_string(image.width))
        .add(std::to_string(image.height));
    drawn.fold(key, frame);
  }
  FramePlaces places(const FrameState& frame) const {
    const Settings& settings = frame.settings;
    return {settings.camera, settings.image.width, settings.image.height, drawn.get(frame)};
  }
};
struct MotionPlacesInput {
  BoundMotionPlaces bind(Flow& flow) const { return {&flow, DrawItemsInput{}.bind(flow)}; }
  static std::vector<PassInput> told() {
    return {{CameraParams::description().group},
            {ModelParams::description().group},
            {ImageParams::description().group},
            {"", [] { return MeshesPass::kind().name; }, true}};
  }
};

glm::mat4 projection_of(const FramePlaces& places) {
  return projection_matrix(places.camera,
                           static_cast<float>(places.width_px) / static_cast<float>(places.height_px));
}

/// From one frame's eye space to the other's, for a point that stays on its model; in doubles, since far from
/// the origin the parts are large and the whole is not. All 0 where the other frame does not show the mesh.
glm::mat4 eye_to_eye(const DrawItem& item, const FramePlaces& here, const FramePlaces& other) {
  const std::vector<DrawItem>& items = other.drawn.items;
  const auto found = std::find_if(items.begin(), items.end(), [&](const DrawItem& candidate) {
    return candidate.object_id == item.object_id && candidate.mesh == item.mesh;
  });
  if (found == items.end()) return glm::mat4(0.0F);
  const glm::dmat4 to_eye = glm::dmat4(view_matrix(here.camera)) * glm::dmat4(item.model_to_world);
  const glm::dmat4 to_other = glm::dmat4(view_matrix(other.camera)) * glm::dmat4(found->model_to_world);
  return glm::mat4(to_other * glm::inverse(to_eye));
}

MotionBlock motion_block(const FramePlaces& here, const FramePlaces& other) {
  return {.projection = projection_of(here),
          .other_projection = projection_of(other),
          .size_px = {here.width_px, here.height_px},
          .other_size_px = {other.width_px, other.height_px},
          .far = here.camera.far};
}

/// Of the models with the ids from `first` + 1 on.
ModelMoves model_moves(const FramePlaces& here, const FramePlaces& other, int first) {
  ModelMoves moves;
  moves.fill(glm::mat4(0.0F));
  for (const DrawItem& item : here.drawn.items) {
    const int place = item.object_id - 1 - first;
    if (place >= 0 && place < kModelsAtOnce) moves[place] = eye_to_eye(item, here, other);
  }
  return moves;
}

}  // namespace

constinit const BufferName BufferName::motion{kMotion};

const PassKind& MotionPass::kind() {
  static const PassKind kKind = describe_pass<MotionPass>("motion", 3, {shows(BufferName::motion)},
                                                          MotionPlacesInput{}, value_of<GBufferPass>());
  return kKind;
}

MotionPass::MotionPass(const GeneratedSources& generated)
    : program_(
          "full_screen.vert", "motion.frag",
          {.samplers = {"normal_and_depth_map", "object_id_map"},
           .uniform_blocks = {{"motion_block", sizeof(MotionBlock)}, {"motion_models", sizeof(ModelMoves)}}},
          generated) {}

Texture MotionPass::run(const MotionPlaces& places, const GBuffer& gbuffer) const {
  const FramePlaces& here = places.here;
  Texture result("motion", TextureFormat::rgba32f, here.width_px, here.height_px);
  const RenderTarget target({&result}, nullptr);
  if (!places.before) {
    constexpr std::array kNone{0.0F, 0.0F, 0.0F, 0.0F};
    glClearBufferfv(GL_COLOR, 0, kNone.data());
    return result;
  }
  MotionBlock block = motion_block(here, *places.before);
  const int models = here.drawn.items.empty() ? 0 : here.drawn.items.back().object_id;
  program_.use();
  bind_textures({&gbuffer.normal_and_depth, &gbuffer.object_id});
  // Each go draws the pixels of its own models, the first one also the background.
  do {
    const ModelMoves moves = model_moves(here, *places.before, block.first_model);
    const Buffer uniforms = uniform_buffer("motion block", block);
    const Buffer list("motion models", bytes_of(std::span<const glm::mat4>(moves)));
    bind_uniform_blocks({&uniforms, &list});
    draw_full_screen();
    block.first_model += kModelsAtOnce;
  } while (block.first_model < models);
  return result;
}

}  // namespace inkbench
