// SPDX-License-Identifier: MIT
// A list of vectors that shaders read by index (`samplerBuffer`): what every triangle of a mesh has. In:
// vectors. Out: a texture over a buffer of them.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "pipeline/gl/object.h"

namespace inkbench {

class BufferTexture {
 public:
  BufferTexture() = default;
  /// A texel a vector, as rgb32f. Errors (work): more than the renderer's texture buffers hold.
  BufferTexture(const std::string& label, std::span<const glm::vec3> vectors);
  /// For the shader's sampler at `unit`.
  void bind(GLuint unit) const { glBindTextureUnit(unit, name_.id()); }

 private:
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
  Buffer buffer_;
  GlName<&BufferTexture::destroy> name_;
};

}  // namespace inkbench
