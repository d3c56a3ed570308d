// What of the window is remembered from start to start: sizes, dividers, which panels are open, the theme.
// Described like every other parameter, so that one visitor reads and writes it.
#pragma once

#include <filesystem>
#include <string>

#include "app/window/theme.h"
#include "pipeline/params/description.h"

namespace inkbench {

struct WindowParams {
  int width = 1280, height = 800;
  int left = 320, right = 276, bottom = 170;
  bool show_left = true, show_right = true, show_bottom = true;
  ThemeName theme = ThemeName::dark;
  float zoom = 1.0F;
  bool keys_page = true;
  std::string open_groups = "mesh ramp combine ink";
  std::string hidden_buffers;

  static const Description& description();
};

/// What the file says; a missing one says nothing. Errors (input): file and line of what it should not say.
WindowParams load_window_params(const std::filesystem::path& path);

/// Errors (work): as `write_file_atomically`.
void save_window_params(const std::filesystem::path& path, const WindowParams& params);

/// "a b c" as a list of words: whether it has `word`, and the list with it or without it.
bool has_word(const std::string& words, std::string_view word);
std::string with_word(const std::string& words, std::string_view word, bool present);

}  // namespace inkbench
