// SPDX-License-Identifier: MIT
#include "pipeline/gl/object.h"

namespace inkbench {

Buffer::Buffer(const std::string& label, std::span<const uint8_t> bytes) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  name_ = GlName<&Buffer::destroy>(id);
  label_object(GL_BUFFER, id, label);
  glNamedBufferStorage(id, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
}

VertexArray::VertexArray(const std::string& label) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  name_ = GlName<&VertexArray::destroy>(id);
  label_object(GL_VERTEX_ARRAY, id, label);
}

}  // namespace inkbench
