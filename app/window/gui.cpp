// SPDX-License-Identifier: MIT
#include "app/window/gui.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui_freetype.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "pipeline/base/log.h"
#include "pipeline/gl/gl_context.h"

namespace inkbench {
namespace {

constexpr float kTextSize = 15.0F;  // line height in px on an ordinary display
constexpr float kFixedSize = 14.0F;

Fonts& current_fonts() {
  static Fonts value;
  return value;
}

/// Latin, Greek and Cyrillic for file names, and the few signs that labels use.
const ImWchar* glyph_ranges() {
  static const ImWchar kRanges[] = {0x0020, 0x017f, 0x0370, 0x04ff, 0x2010, 0x2026, 0x2190, 0x2193,
                                    0x2212, 0x2212, 0x25a0, 0x25cf, 0x2713, 0x2715, 0};
  return kRanges;
}

ImFont* load_font(const std::string& file, float size_px) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  for (const char* folder : {"truetype/dejavu", "dejavu-sans-fonts", "dejavu-sans-mono-fonts", "TTF"}) {
    const std::filesystem::path path = std::filesystem::path("/usr/share/fonts") / folder / file;
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error))
      return atlas.AddFontFromFileTTF(path.c_str(), size_px, nullptr, glyph_ranges());
  }
  log_note("the font " + file + " was not found; install the package fonts-dejavu-core");
  return atlas.AddFontDefault();
}

}  // namespace

const Fonts& fonts() {
  return current_fonts();
}

Gui::Gui(Window& window, InputQueue& input) : window_(window), input_(input) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // what is remembered is remembered by us
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // blinking would need frames while nothing changes
  ImGui_ImplGlfw_InitForOpenGL(window.handle(), false);
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Gui::set_look(Theme name, float scale) {
  look_changed_ |= name != theme_ || scale != scale_;
  theme_ = name;
  scale_ = scale;
}

void Gui::make_fonts(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  current_fonts() = {load_font("DejaVuSans.ttf", std::round(kTextSize * scale)),
                     load_font("DejaVuSans-Bold.ttf", std::round(kTextSize * scale)),
                     load_font("DejaVuSansMono.ttf", std::round(kFixedSize * scale))};
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  font_scale_ = scale;
}

void Gui::begin_frame() {
  const float scale = scale_ > 0.0F ? scale_ : window_.content_scale();
  if (scale != font_scale_) {
    make_fonts(scale);
    look_changed_ = true;
  }
  if (look_changed_) apply_theme(theme_, scale);
  look_changed_ = false;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  input_.feed();
  ImGui::NewFrame();
}

bool Gui::is_measuring() const {
  const auto& windows = ImGui::GetCurrentContext()->Windows;
  return std::any_of(windows.begin(), windows.end(), [](const ImGuiWindow* window) {
    return window->Active && window->HiddenFramesCannotSkipItems > 0;
  });
}

void Gui::end_frame() {
  ImGui::Render();
  const WindowSize size = window_.size();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.width_px, size.height_px);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const ImVec4 back = as_vec4(theme().line);
  glClearColor(back.x, back.y, back.z, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  throw_gl_errors("drawing the window");
}

}  // namespace inkbench
