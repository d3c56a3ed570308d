// SPDX-License-Identifier: MIT
// An OpenGL 4.5 core context without a window, from EGL: a GPU's device platform where there is one, else
// Mesa's software renderer without a surface.
#pragma once

#include <optional>
#include <string>

#include "pipeline/gl/gl_context.h"

namespace inkbench {

/// Which renderer to ask for; from $INKBENCH_RENDERER ("auto", "gpu", "software") where it is set.
enum class RendererChoice { automatic, gpu, software };

class HeadlessContext {
 public:
  /// Makes the context and makes it current on this thread. Errors (work): no EGL or no OpenGL 4.5, with the
  /// package to install; (input) $INKBENCH_RENDERER is none of its words.
  HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;
  ~HeadlessContext();

  /// "device" or "surfaceless": how EGL gave the context.
  const std::string& platform() const { return platform_; }

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::string platform_;
  std::optional<GlContext> resources_;
};

/// What `inkbench info` and manifests say of the current context.
struct RendererInfo {
  std::string renderer, vendor, version;
  int max_side_px = 0;  ///< Largest texture side.
};
RendererInfo renderer_info();

}  // namespace inkbench
