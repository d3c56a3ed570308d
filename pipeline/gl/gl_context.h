// SPDX-License-Identifier: MIT
// What belongs to an OpenGL context beside the objects that others own: textures for reuse, the vertex array
// of draws without attributes, what OpenGL reported. Each way of making a context owns one.
#pragma once

#include <string>

#include "pipeline/gl/object.h"
#include "pipeline/gl/texture_pool.h"

namespace inkbench {

class GlContext {
 public:
  /// Of the OpenGL context that is current on this thread, whose debug messages it takes from now on. The
  /// OpenGL context must be current again when it ends, and all that was made in it gone.
  GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  ~GlContext();

  /// That of this thread, which must have one.
  static GlContext& current();

  TexturePool& textures() { return textures_; }
  /// The core profile wants one bound, even for draws without attributes.
  const VertexArray& empty_vertex_array() const { return empty_vertex_array_; }
  /// What OpenGL reported and nobody took yet.
  std::string& reported_errors() { return reported_errors_; }

 private:
  GlContext* const before_;  ///< Current again when this one ends.
  std::string reported_errors_;
  TexturePool textures_;
  VertexArray empty_vertex_array_;
};

/// Errors (work): what OpenGL reported since the last call, with `where` (a pass's name).
void throw_gl_errors(const std::string& where);

/// Forgets what OpenGL reported, where the caller reports it itself (a compiler's log).
void discard_gl_errors();

}  // namespace inkbench
