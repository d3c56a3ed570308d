#include "pipeline/gl/framebuffer.h"

#include <array>
#include <cassert>

namespace inkbench {

RenderTarget::RenderTarget(std::initializer_list<const Texture*> colours, const Texture* depth) {
  glCreateFramebuffers(1, &id_);
  std::array<GLenum, 8> attachments{};
  GLsizei count = 0;
  for (const Texture* colour : colours) {
    attachments[count] = GL_COLOR_ATTACHMENT0 + count;
    glNamedFramebufferTexture(id_, attachments[count], colour->id(), 0);
    ++count;
  }
  glNamedFramebufferDrawBuffers(id_, count, attachments.data());
  if (depth != nullptr) glNamedFramebufferTexture(id_, GL_DEPTH_ATTACHMENT, depth->id(), 0);
  assert(glCheckNamedFramebufferStatus(id_, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  const Texture& first = **colours.begin();
  glViewport(0, 0, first.width_px(), first.height_px());
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
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
  glDeleteFramebuffers(1, &id_);
}

void draw_full_screen() {
  static thread_local GLuint vertex_array = 0;  // core profile wants one bound, even without attributes
  if (vertex_array == 0 || glIsVertexArray(vertex_array) == GL_FALSE) glCreateVertexArrays(1, &vertex_array);
  glBindVertexArray(vertex_array);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace inkbench
