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

/// Where clip space lies in the target until the next one is made, px from its lower left corner; it may
/// reach beyond the target.
void set_viewport(int left, int bottom, int width_px, int height_px);
/// The longest side that it can have.
int largest_viewport_px();

/// Sets all channels of the target's first `count` colours to 0.
void clear_colours(int count);

/// Until the next target is made, each channel keeps the larger of what is there and what is drawn.
void blend_by_maximum();

/// Draws one triangle over the whole target with the program in use.
void draw_full_screen();

/// The same over a rectangle of it alone, px from its lower left corner.
void draw_rectangle(int left, int bottom, int width_px, int height_px);

/// Draws so many points, which the program in use places by their number and gives a size.
void draw_points(int count);

}  // namespace inkbench
