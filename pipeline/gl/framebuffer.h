// SPDX-License-Identifier: MIT
// Where a pass draws: a framebuffer over textures, bound for as long as the object lives.
#pragma once

#include <initializer_list>

#include "pipeline/gl/texture.h"

namespace inkbench {

class RenderTarget {
 public:
  /// Colour textures in the order of the shader's outputs, and a depth texture or nullptr; all of one size.
  /// Sets the viewport and, whatever others left, all state that decides what is drawn: depth testing exactly
  /// when there is a depth texture; no culling, blending, scissor or masks. Errors (work): the renderer
  /// cannot draw into these textures together, with the first one's label and OpenGL's word for why.
  RenderTarget(std::initializer_list<const Texture*> colours, const Texture* depth);
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;
  ~RenderTarget();

 private:
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
  GlName<&RenderTarget::destroy> name_;
};

/// Draws one triangle over the whole target with the program in use.
void draw_full_screen();

/// Draws so many points, which the program in use places by their number and gives a size.
void draw_points(int count);

}  // namespace inkbench
