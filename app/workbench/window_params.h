// What of the window is remembered from start to start: sizes, dividers, which panels are open, the theme.
// Described like every other parameter, so that the session file and its checks are visitors over it.
#pragma once

#include <string>
#include <string_view>

#include "app/workbench/theme_name.h"

namespace inkbench {

/// What the panel on the left shows.
enum class LeftTab { parameters, presets, history, views };
template <>
struct ChoiceNames<LeftTab> {
  static constexpr std::array<std::string_view, 4> names{"parameters", "presets", "history", "views"};
};

struct WindowParams {
  int width = 1280, height = 800;
  bool maximised = false;
  int left = 330, right = 250, bottom = 170;
  bool show_left = true, show_right = true, show_bottom = true;
  LeftTab left_tab = LeftTab::parameters;
  ThemeName theme = ThemeName::dark;
  float zoom = 1.0F;
  bool keys_page = true;
  std::string open_groups = "mesh ramp combine ink";
  std::string hidden_buffers;

  static const Description& description();
  bool operator==(const WindowParams&) const = default;
};

/// "a b c" as a list of words: whether it has `word`, and the list with it or without it.
bool has_word(const std::string& words, std::string_view word);
std::string with_word(const std::string& words, std::string_view word, bool present);

}  // namespace inkbench
