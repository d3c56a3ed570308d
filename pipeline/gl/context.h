// An OpenGL 4.5 core context without a window, from EGL: a GPU's device platform where there is one, else
// Mesa's software renderer without a surface.
#pragma once

#include <string>

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
};

/// What `inkbench info` and manifests say of the current context.
struct RendererInfo {
  std::string renderer, vendor, version;
  int max_side_px = 0;  ///< Largest texture side.
};
RendererInfo renderer_info();

/// Sends OpenGL's debug messages to us from now on; called by every way of making a context.
void enable_debug_output();

/// Errors (work): what OpenGL reported since the last call, with `where` (a pass's name).
void throw_gl_errors(const std::string& where);

/// Forgets what OpenGL reported, where the caller reports it itself (a compiler's log).
void discard_gl_errors();

}  // namespace inkbench
