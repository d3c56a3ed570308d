// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/gbuffer.h"

#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/gbuffer/lens_block.h"
#include "pipeline/passes/gbuffer/meshes.h"

namespace inkbench {
namespace {

constexpr BufferInfo kObjectId{
    .name = "object_id", .help = "A colour for each model.", .number_key = 9, .shown_as = ShownAs::object_id};

/// shaders/lib/draw_block.glsl in std140.
struct DrawBlock {
  glm::mat4 model_to_clip;
  glm::mat4 normal_to_world;
  float object_id;
  float far;
  float two_sided;
  float orthographic;
  glm::vec4 model_to_distance;
};

/// surface_block of shaders/gbuffer_surface.frag in std140.
struct SurfaceBlock {
  glm::mat4 normal_to_view;
  glm::vec2 middle_px;
  glm::vec2 padding;
};

/// Distance from the eye to the farthest point of the near plane that the image shows.
double near_corner_distance(const CameraParams& camera, double aspect) {
  const double half_height = seen_height(camera, camera.near) / 2.0;
  return glm::length(glm::dvec3(half_height * aspect, half_height, camera.near));
}

/// Whether the back faces are hidden for certain: the mesh is closed, and eye and near plane are outside its
/// box. Then leaving them out changes no pixel and saves a third of the pass.
bool back_faces_hidden(const DrawItem& item, const CameraParams& camera, float aspect) {
  if (!item.mesh->closed_outwards()) return false;
  const Bounds box = bounds_in_world(item);
  if (is_orthographic(camera)) return nearest_along_view(box, camera) > camera.near;
  return distance_outside(box, camera.eye) > near_corner_distance(camera, aspect);
}

/// Of a point of the item's model, the distance along the view axis is its dot product with this.
glm::vec4 model_to_distance(const glm::mat4& world_to_view, const DrawItem& item) {
  return -glm::row(world_to_view * item.model_to_world, 2);
}

/// Run with: bool. It is in no key, since it changes none of the other maps (`lacks_part`).
struct SurfaceWanted {
  SurfaceWanted bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {}; }
  void fold(KeyBuilder&, const FrameState&) const {}
  bool get(const FrameState& frame) const { return needs_surface(frame.settings); }
};

RenderTarget target_of(const GBuffer& gbuffer, const Texture& hidden_surfaces) {
  if (gbuffer.surface.id() == 0)
    return RenderTarget({&gbuffer.normal_and_depth, &gbuffer.object_id}, &hidden_surfaces);
  return RenderTarget({&gbuffer.normal_and_depth, &gbuffer.object_id, &gbuffer.surface}, &hidden_surfaces);
}

}  // namespace

constinit const BufferName BufferName::object_id{kObjectId};

bool GBufferPass::lacks_part(const GBuffer& held, const Settings& settings) {
  return needs_surface(settings) && held.surface.id() == 0;
}

bool needs_surface(const Settings& settings) {
  return settings.edges.method == EdgeMethod::dihedral;
}

const PassKind& GBufferPass::kind() {
  static const PassKind kKind = describe_pass<GBufferPass>(
      "gbuffer", 10, {shows(BufferName::object_id, &GBuffer::object_id)}, group<&Settings::camera>(),
      DrawItemsInput{}, WindowInput{}, SurfaceWanted{});
  return kKind;
}

GBufferPass::GBufferPass(const GeneratedSources& generated)
    : maps_("gbuffer.vert", "gbuffer.frag", {.uniform_blocks = {{"draw_block", sizeof(DrawBlock)}}},
            generated),
      maps_and_surface_("gbuffer.vert", "gbuffer_surface.frag",
                        {.samplers = {"face_normals"},
                         .uniform_blocks = {{"draw_block", sizeof(DrawBlock)},
                                            kLensBlock,
                                            {"surface_block", sizeof(SurfaceBlock)}}},
                        generated) {}

GBuffer GBufferPass::run(const CameraParams& camera, std::span<const DrawItem> items,
                         const ImageWindow& window, bool with_surface) const {
  const int width_px = window.width, height_px = window.height;
  GBuffer result{Texture("normal and depth", TextureFormat::rgba32f, width_px, height_px),
                 Texture("object id", TextureFormat::r32f, width_px, height_px),
                 with_surface ? Texture("surface", TextureFormat::rgba32f, width_px, height_px) : Texture()};
  const Texture hidden_surfaces("hidden surfaces", TextureFormat::depth32f, width_px, height_px);
  const RenderTarget target = target_of(result, hidden_surfaces);
  constexpr std::array kNoNormalAndFar{0.5F, 0.5F, 0.5F, 1.0F};
  constexpr std::array kNoId{0.0F, 0.0F, 0.0F, 0.0F};
  constexpr float kFarthest = 1.0F;
  glClearBufferfv(GL_COLOR, 0, kNoNormalAndFar.data());
  glClearBufferfv(GL_COLOR, 1, kNoId.data());
  if (with_surface) glClearBufferfv(GL_COLOR, 2, kNoId.data());
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
  if (window.is_whole()) beyond_far_->update(items, camera);
  program(with_surface).use();
  const float aspect = window.whole_aspect();
  const glm::mat4 world_to_view = view_matrix(camera);
  const ImageWindow projected = projected_window(window, largest_viewport_px());
  set_viewport(projected.left - window.left, projected.bottom - window.bottom, projected.width,
               projected.height);
  const glm::mat4 world_to_clip = projection_matrix(camera, projected) * world_to_view;
  const Buffer lens = lens_buffer(lens_of(camera, window.whole_height));
  for (const DrawItem& item : items) {
    const glm::mat4 normal_to_world(glm::transpose(glm::inverse(glm::mat3(item.model_to_world))));
    const DrawBlock block{world_to_clip * item.model_to_world,   normal_to_world,
                          static_cast<float>(item.object_id),    camera.far,
                          item.two_sided ? 1.0F : 0.0F,          is_orthographic(camera) ? 1.0F : 0.0F,
                          model_to_distance(world_to_view, item)};
    const Buffer uniforms("draw block", bytes_of(std::span(&block, 1)));
    bind_uniform_blocks({&uniforms});
    std::optional<Buffer> surface;
    if (with_surface) {
      const SurfaceBlock planes{
          glm::mat4(glm::mat3(world_to_view)) * normal_to_world, window.middle_px(), {}};
      surface.emplace("surface block", bytes_of(std::span(&planes, 1)));
      bind_uniform_blocks({&uniforms, &lens, &*surface});
      item.mesh->face_normals().bind(0);
    }
    // A mirrored model's faces turn the other way on the screen.
    glFrontFace(glm::determinant(glm::mat3(item.model_to_world)) < 0.0F ? GL_CW : GL_CCW);
    (back_faces_hidden(item, camera, aspect) ? glEnable : glDisable)(GL_CULL_FACE);
    item.mesh->draw();
  }
  return result;
}

}  // namespace inkbench
