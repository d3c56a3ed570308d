// SPDX-License-Identifier: MIT
#include "pipeline/gl/framebuffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/base/error.h"
#include "pipeline/gl/gl_context.h"

namespace inkbench {
namespace {

GLuint make_framebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  return id;
}

std::string label_of(const Texture& texture) {
  std::array<char, 256> label{};
  glGetObjectLabel(GL_TEXTURE, texture.id(), static_cast<GLsizei>(label.size()), nullptr, label.data());
  return label.data();
}

std::string status_word(GLenum status) {
  switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
      return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
      return "GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT";
    case GL_FRAMEBUFFER_UNSUPPORTED:
      return "GL_FRAMEBUFFER_UNSUPPORTED";
    default:
      return fmt::format("status 0x{:04X}", status);
  }
}

void check_complete(GLuint framebuffer, const Texture& first) {
  const GLenum status = glCheckNamedFramebufferStatus(framebuffer, GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw work_error(label_of(first),
                   "the renderer cannot draw into its textures together: " + status_word(status),
                   "a renderer of OpenGL 4.5 can; INKBENCH_RENDERER=software chooses Mesa's");
}

}  // namespace

RenderTarget::RenderTarget(std::initializer_list<const Texture*> colours, const Texture* depth)
    : name_(make_framebuffer()) {
  std::array<GLenum, 8> attachments{};
  GLsizei count = 0;
  for (const Texture* colour : colours) {
    attachments[count] = GL_COLOR_ATTACHMENT0 + count;
    glNamedFramebufferTexture(name_.id(), attachments[count], colour->id(), 0);
    ++count;
  }
  glNamedFramebufferDrawBuffers(name_.id(), count, attachments.data());
  if (depth != nullptr) glNamedFramebufferTexture(name_.id(), GL_DEPTH_ATTACHMENT, depth->id(), 0);
  const Texture& first = **colours.begin();
  check_complete(name_.id(), first);
  glBindFramebuffer(GL_FRAMEBUFFER, name_.id());
  glViewport(0, 0, first.width_px(), first.height_px());
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);  // clearing obeys it, too
  glDepthFunc(GL_LESS);
  (depth != nullptr ? glEnable : glDisable)(GL_DEPTH_TEST);
}

RenderTarget::~RenderTarget() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void set_viewport(int left, int bottom, int width_px, int height_px) {
  glViewport(left, bottom, width_px, height_px);
}

int largest_viewport_px() {
  std::array<GLint, 2> sides{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, sides.data());
  return std::min(sides[0], sides[1]);
}

void clear_colours(int count) {
  constexpr std::array kNone{0.0F, 0.0F, 0.0F, 0.0F};
  for (int i = 0; i < count; ++i) glClearBufferfv(GL_COLOR, i, kNone.data());
}

void blend_by_maximum() {
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
}

void draw_full_screen() {
  glBindVertexArray(GlContext::current().empty_vertex_array().id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void draw_rectangle(int left, int bottom, int width_px, int height_px) {
  set_viewport(left, bottom, width_px, height_px);
  draw_full_screen();
}

void draw_points(int count) {
  glBindVertexArray(GlContext::current().empty_vertex_array().id());
  glDrawArrays(GL_POINTS, 0, count);
}

}  // namespace inkbench
