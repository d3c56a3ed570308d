// SPDX-License-Identifier: MIT
#include "pipeline/gl/buffer_texture.h"

#include <fmt/format.h>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

void check_room(const std::string& label, size_t texels) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (texels <= static_cast<size_t>(most)) return;
  throw work_error(label,
                   fmt::format("has {} entries, and this renderer's texture buffers hold {}", texels, most),
                   "draw a level of the mesh with fewer faces, or choose another renderer");
}

}  // namespace

BufferTexture::BufferTexture(const std::string& label, std::span<const glm::vec3> vectors) {
  check_room(label, vectors.size());
  buffer_ = Buffer(label, bytes_of(vectors));
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
  name_ = GlName<&BufferTexture::destroy>(id);
  label_object(GL_TEXTURE, id, label);
  glTextureBuffer(id, GL_RGB32F, buffer_.id());
}

}  // namespace inkbench
