// SPDX-License-Identifier: MIT
#include "app/window/wire_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "pipeline/gl/framebuffer.h"
#include "pipeline/gl/gl_context.h"
#include "pipeline/passes/gbuffer/gbuffer.h"

namespace inkbench {
namespace {

/// wire_block of shaders/wire.vert in std140.
struct WireBlock {
  glm::mat4 model_to_tile;
  glm::vec4 colour;
};

/// The picture's clip space to the tile's: a scale and a shift across the image.
glm::mat4 picture_to_tile(const WireView& view, const ImageParams& image) {
  const double across = image.width / (view.place.step * view.width_px);
  const double down = image.height / (view.place.step * view.height_px);
  glm::mat4 matrix(1.0F);
  matrix[0][0] = static_cast<float>(across);
  matrix[1][1] = static_cast<float>(down);
  matrix[3][0] = static_cast<float>(across - 2.0 * view.place.left / (view.place.step * view.width_px) - 1.0);
  matrix[3][1] = static_cast<float>(1.0 - down + 2.0 * view.place.top / (view.place.step * view.height_px));
  return matrix;
}

/// Lines end where the picture ends.
void clip_to_picture(const WireView& view, const ImageParams& image) {
  const double left = -view.place.left / view.place.step;
  const double top = -view.place.top / view.place.step;
  const double right = left + image.width / view.place.step;
  const double bottom = top + image.height / view.place.step;
  const auto inside = [](double value, int size) {
    return static_cast<GLint>(std::lround(std::clamp(value, 0.0, static_cast<double>(size))));
  };
  const GLint x = inside(left, view.width_px);
  const GLint y = view.height_px - inside(bottom, view.height_px);
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, inside(right, view.width_px) - x, view.height_px - inside(top, view.height_px) - y);
}

/// The lines of dense meshes would cover the picture: they fade.
float opacity(const GpuMesh& mesh, const WireView& view, const ImageParams& image) {
  const double area = image.width * image.height / (view.place.step * view.place.step);
  const double edge_px = std::sqrt(area / static_cast<double>(std::max<size_t>(mesh.face_count(), 1)));
  return static_cast<float>(std::clamp(edge_px / 10.0, 0.3, 0.85));
}

}  // namespace

WirePainter::WirePainter()
    : program_("wire.vert", "wire.frag", {.uniform_blocks = {{"wire_block", sizeof(WireBlock)}}}, {}) {}

Texture WirePainter::run(const Frame& frame, const WireView& view) const {
  const Settings& settings = frame.settings();
  const std::vector<DrawItem> items = frame.draw_items();
  Texture tile("wireframe", TextureFormat::rgba8, view.width_px, view.height_px);
  const Texture depth("hidden edges", TextureFormat::depth32f, view.width_px, view.height_px);
  const RenderTarget target({&tile}, &depth);
  constexpr std::array kNothing{0.0F, 0.0F, 0.0F, 0.0F};
  constexpr float kFarthest = 1.0F;
  glClearBufferfv(GL_COLOR, 0, kNothing.data());
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
  clip_to_picture(view, settings.image);
  program_.use();
  const float aspect = static_cast<float>(settings.image.width) / static_cast<float>(settings.image.height);
  const glm::mat4 world_to_tile = picture_to_tile(view, settings.image) *
                                  projection_matrix(settings.camera, aspect) * view_matrix(settings.camera);
  const auto draw_all = [&] {
    for (const DrawItem& item : items) {
      const glm::vec4 colour(glm::vec3(view.colour), opacity(*item.mesh, view, settings.image));
      const WireBlock block{world_to_tile * item.model_to_world, colour};
      const Buffer uniforms("wire block", bytes_of(std::span(&block, 1)));
      bind_uniform_blocks({&uniforms});
      item.mesh->draw();
    }
  };
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);  // behind their own edges
  glPolygonOffset(1.0F, 1.0F);
  draw_all();
  glDisable(GL_POLYGON_OFFSET_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glDepthFunc(GL_LEQUAL);
  draw_all();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_SCISSOR_TEST);
  throw_gl_errors("the wireframe");
  return tile;
}

const Texture& WirePainter::paint(const Frame& frame, const WireView& view) {
  const Key key = KeyBuilder()
                      .add("wireframe")
                      .add(program_.key())
                      .add(frame.key_of<GBufferPass>())
                      .add(fmt::format("{} {} {} {} {}", view.place.left, view.place.top, view.place.step,
                                       view.width_px, view.height_px))
                      .add(fmt::format("{} {} {}", view.colour.x, view.colour.y, view.colour.z))
                      .key();
  return tile_.get(key, [&] { return run(frame, view); });
}

}  // namespace inkbench
