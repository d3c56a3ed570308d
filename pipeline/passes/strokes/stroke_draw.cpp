// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/stroke_draw.h"

#include <algorithm>

#include "pipeline/gl/framebuffer.h"
#include "pipeline/passes/strokes/brush_image.h"
#include "pipeline/passes/strokes/stroke_points.h"
#include "pipeline/passes/strokes/stroke_tiles.h"

namespace inkbench {
namespace {

/// strokes_block of shaders/lib/stroke_block.glsl in std140.
struct StrokesBlock {
  glm::vec2 whole_size_px;
  glm::vec2 corner_px;
  glm::vec2 size_px;
  float hidden_share;
  float length_px;
  float grain;
  int is_stretched;
  glm::vec2 padding;
};
const UniformBlock kStrokesBlock{"strokes_block", sizeof(StrokesBlock)};

StrokesBlock block_of(const BrushParams& brush, const ImageWindow& window) {
  return {.whole_size_px = window.whole_size_px(),
          .corner_px = window.corner_px(),
          .size_px = {window.width, window.height},
          .hidden_share = brush.hidden_opacity,
          .length_px = brush.length_px,
          .grain = brush.grain,
          .is_stretched = brush.fit == BrushFit::stretch ? 1 : 0,
          .padding = {}};
}

/// Attribute `number` of a segment: a vector of the point `ahead` of its first neighbour.
void attach(const VertexArray& vertex_array, const Buffer& points, GLuint number, int ahead, size_t offset) {
  const auto start = static_cast<GLintptr>(ahead * sizeof(DrawnPoint) + offset);
  glVertexArrayVertexBuffer(vertex_array.id(), number, points.id(), start, sizeof(DrawnPoint));
  glEnableVertexArrayAttrib(vertex_array.id(), number);
  glVertexArrayAttribFormat(vertex_array.id(), number, 4, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(vertex_array.id(), number, number);
  glVertexArrayBindingDivisor(vertex_array.id(), number, 1);
}

void draw_segments(const std::vector<DrawnPoint>& list) {
  constexpr int kPlaces = 2 * kNeighbours + 2;
  const Buffer points("stroke points", bytes_of(std::span(list)));
  const VertexArray vertex_array("stroke segments");
  for (int i = 0; i < kPlaces; ++i) attach(vertex_array, points, i, i, offsetof(DrawnPoint, place));
  attach(vertex_array, points, kPlaces, kNeighbours, offsetof(DrawnPoint, paint));
  glBindVertexArray(vertex_array.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(list.size()) - kPlaces + 1);
}

float widest_px(const Strokes& strokes) {
  float widest = 0.0F;
  for (const Stroke& stroke : strokes.strokes) {
    for (const StrokePoint& point : stroke.points) widest = std::max(widest, 2.0F * point.radius_px);
  }
  return widest;
}

float longest_px(const Strokes& strokes) {
  float longest = 0.0F;
  for (const Stroke& stroke : strokes.strokes) longest = std::max(longest, stroke.end_px - stroke.start_px);
  return longest;
}

/// The brush's picture as it is drawn with.
Texture brush_texture(const BrushParams& brush, const Strokes& strokes) {
  const float along_px = brush.fit == BrushFit::stretch ? longest_px(strokes) : brush.length_px;
  const Image paint = reduced_paint(brush_paint(brush.image), along_px, widest_px(strokes));
  Texture texture("brush", TextureFormat::r32f, paint.width_px, paint.height_px);
  texture.upload(paint);
  return texture;
}

}  // namespace

BrushParams brush_of(const StrokeParams& params) {
  return {params.brush,     params.brush_image, params.brush_length,
          params.brush_fit, params.grain,       params.hidden_opacity};
}

StrokeDrawPass::StrokeDrawPass(const GeneratedSources& generated) {
  for (const std::string_view name : ChoiceNames<Brush>::names) {
    const ProgramInputs inputs{.samplers = {"brush_map"}, .uniform_blocks = {kStrokesBlock}};
    brushes_.emplace_back("strokes.vert", "strokes_" + std::string(name) + ".frag", inputs, generated);
  }
}

std::vector<Program*> StrokeDrawPass::programs() {
  std::vector<Program*> programs;
  for (Program& program : brushes_) programs.push_back(&program);
  return programs;
}

StrokeChannels StrokeDrawPass::run(const BrushParams& brush, const ImageWindow& window,
                                   const Strokes& strokes) const {
  StrokeChannels channels;
  for (Texture& texture : channels.classes)
    texture = Texture("stroke classes", TextureFormat::rgba8, window.width, window.height);
  const Image tiles = stroke_tiles(strokes, window);
  channels.tiles = Texture("stroke tiles", TextureFormat::r8, tiles.width_px, tiles.height_px);
  channels.tiles.upload(tiles);
  const auto& [first, next, last] = channels.classes;
  const RenderTarget target({&first, &next, &last}, nullptr);
  clear_colours(3);
  channels.widest_px = widest_px(strokes);
  const std::vector<DrawnPoint> points = drawn_points(strokes);
  if (points.empty()) return channels;
  brushes_[static_cast<size_t>(brush.brush)].use();
  Texture picture;
  if (brush.brush == Brush::image) {
    picture = brush_texture(brush, strokes);
    bind_textures({&picture});
  }
  const Buffer uniforms = uniform_buffer("strokes block", block_of(brush, window));
  bind_uniform_blocks({&uniforms});
  blend_by_maximum();
  draw_segments(points);
  return channels;
}

}  // namespace inkbench
