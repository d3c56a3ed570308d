// SPDX-License-Identifier: MIT
#include "pipeline/gl/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

struct Candidate {
  EGLDisplay display;
  std::string platform;
};

RendererChoice renderer_choice() {
  const char* text = std::getenv("INKBENCH_RENDERER");
  const std::string_view word = text == nullptr ? "" : text;
  if (word.empty() || word == "auto") return RendererChoice::automatic;
  if (word == "gpu") return RendererChoice::gpu;
  if (word == "software") return RendererChoice::software;
  throw input_error("INKBENCH_RENDERER", "'" + std::string(word) + "' is not a renderer",
                    "one of: auto, gpu, software");
}

bool has_client_extension(const char* name) {
  return epoxy_has_egl_extension(EGL_NO_DISPLAY, name);
}

std::vector<Candidate> device_displays() {
  std::vector<Candidate> candidates;
  if (!has_client_extension("EGL_EXT_platform_device") || !has_client_extension("EGL_EXT_device_enumeration"))
    return candidates;
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE)
    return candidates;
  for (EGLint i = 0; i < count; ++i) {
    const char* extensions = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
    const bool software =
        extensions != nullptr &&
        std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
    if (!software)
      candidates.push_back(
          {eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr), "device"});
  }
  return candidates;
}

std::vector<Candidate> candidate_displays(RendererChoice choice) {
  std::vector<Candidate> candidates;
  if (choice != RendererChoice::software) candidates = device_displays();
  if (choice != RendererChoice::gpu && has_client_extension("EGL_MESA_platform_surfaceless")) {
    candidates.push_back(
        {eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
         "surfaceless"});
  }
  return candidates;
}

/// A current context on the display, or EGL_NO_CONTEXT.
EGLContext make_current_context(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
    return EGL_NO_CONTEXT;
  eglBindAPI(EGL_OPENGL_API);
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (eglChooseConfig(display, config_attributes, &config, 1, &count) == EGL_FALSE || count == 0)
    config = EGL_NO_CONFIG_KHR;
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_CONTEXT_OPENGL_DEBUG,
                               EGL_TRUE,
                               EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) return EGL_NO_CONTEXT;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
  }
  return context;
}

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

}  // namespace

HeadlessContext::HeadlessContext() {
  // Mesa's warnings about missing devices would mix with ours on stderr.
  setenv("EGL_LOG_LEVEL", "fatal", 0);
  if (!epoxy_has_egl()) {
    throw work_error("EGL", "libEGL.so.1 was not found",
                     "install Debian's packages libegl1 and libgl1-mesa-dri");
  }
  const RendererChoice choice = renderer_choice();
  for (const Candidate& candidate : candidate_displays(choice)) {
    EGLContext context = make_current_context(candidate.display);
    if (context == EGL_NO_CONTEXT) continue;
    display_ = candidate.display;
    context_ = context;
    platform_ = candidate.platform;
    resources_.emplace();
    return;
  }
  throw work_error("EGL",
                   choice == RendererChoice::gpu ? "no GPU gave an OpenGL 4.5 context"
                                                 : "no OpenGL 4.5 context could be made",
                   choice == RendererChoice::gpu
                       ? "install the GPU's driver, or set INKBENCH_RENDERER=software"
                       : "install Debian's packages libegl1, libegl-mesa0 and libgl1-mesa-dri");
}

HeadlessContext::~HeadlessContext() {
  resources_.reset();
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

RendererInfo renderer_info() {
  RendererInfo info{gl_string(GL_RENDERER), gl_string(GL_VENDOR), gl_string(GL_VERSION), 0};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &info.max_side_px);
  return info;
}

}  // namespace inkbench
