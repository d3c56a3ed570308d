#include "pipeline/passes/gbuffer.h"

#include <array>
#include <glm/matrix.hpp>

#include "pipeline/gl/framebuffer.h"

namespace inkbench {
namespace {

/// shaders/lib/draw_block.glsl in std140.
struct DrawBlock {
  glm::mat4 model_to_clip;
  glm::mat4 normal_to_world;
  float object_id;
  float far;
  float padding[2];
};

}  // namespace

GBufferPass::GBufferPass(const GeneratedSources& generated)
    : program_("gbuffer.vert", "gbuffer.frag", {.uniform_blocks = {"draw_block"}}, generated) {}

GBuffer GBufferPass::run(const CameraParams& camera, std::span<const DrawItem> items, int width_px, int height_px) const {
  GBuffer result{Texture("normal and id", TextureFormat::rgba32f, width_px, height_px),
                 Texture("depth", TextureFormat::r32f, width_px, height_px)};
  const Texture hidden_surfaces("hidden surfaces", TextureFormat::depth32f, width_px, height_px);
  const RenderTarget target({&result.normal_and_id, &result.depth}, &hidden_surfaces);
  constexpr std::array kNoNormal{0.5F, 0.5F, 0.5F, 0.0F};
  constexpr std::array kFar{1.0F, 1.0F, 1.0F, 1.0F};
  glClearBufferfv(GL_COLOR, 0, kNoNormal.data());
  glClearBufferfv(GL_COLOR, 1, kFar.data());
  glClearBufferfv(GL_DEPTH, 0, kFar.data());
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  program_.use();
  const float aspect = static_cast<float>(width_px) / static_cast<float>(height_px);
  const glm::mat4 world_to_clip = projection_matrix(camera, aspect) * view_matrix(camera);
  for (const DrawItem& item : items) {
    const glm::mat4 normal_to_world(glm::transpose(glm::inverse(glm::mat3(item.model_to_world))));
    const DrawBlock block{world_to_clip * item.model_to_world, normal_to_world, static_cast<float>(item.object_id),
                          camera.far, {}};
    const Buffer uniforms("draw block", bytes_of(std::span(&block, 1)));
    bind_uniform_blocks({&uniforms});
    item.mesh->draw();
  }
  return result;
}

}  // namespace inkbench
