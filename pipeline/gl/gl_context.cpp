// SPDX-License-Identifier: MIT
#include "pipeline/gl/gl_context.h"

#include <cassert>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

/// OpenGL's own notion of a thread's current context, with what we hold for it.
thread_local GlContext* current_context = nullptr;

/// Comes on the thread that made the call, since debug output is synchronous.
void APIENTRY on_debug_message(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity,
                               GLsizei /*length*/, const GLchar* message, const void* /*user*/) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  if (current_context == nullptr) return;  // while a context is made or ends
  std::string& errors = current_context->reported_errors();
  if (!errors.empty()) errors += " | ";
  if (errors.size() < 2000) errors += message;
}

void enable_debug_output() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(on_debug_message, nullptr);
}

}  // namespace

GlContext::GlContext() : before_(current_context), empty_vertex_array_("no attributes") {
  current_context = this;
  enable_debug_output();
}

GlContext::~GlContext() {
  current_context = before_;
}

GlContext& GlContext::current() {
  assert(current_context != nullptr && "no OpenGL context is current on this thread");
  return *current_context;
}

void throw_gl_errors(const std::string& where) {
  const std::string errors = std::exchange(GlContext::current().reported_errors(), "");
  if (errors.empty()) return;
  if (errors.find("OUT_OF_MEMORY") != std::string::npos) {
    throw work_error(where, "the renderer has not enough memory for it", "choose a smaller image or mesh");
  }
  throw work_error(where, "OpenGL reported: " + errors);
}

void discard_gl_errors() {
  GlContext::current().reported_errors().clear();
}

}  // namespace inkbench
