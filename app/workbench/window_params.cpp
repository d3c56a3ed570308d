#include "app/workbench/window_params.h"

#include "pipeline/base/text.h"

namespace inkbench {

const Description& WindowParams::description() {
  static const Description kDescription{
      "window",
      "The window",
      {
          field<&WindowParams::width>(
              {.name = "width", .help = "Width of the window.", .unit = "px", .limits = {480, 32768}}),
          field<&WindowParams::height>(
              {.name = "height", .help = "Height of the window.", .unit = "px", .limits = {320, 32768}}),
          field<&WindowParams::maximised>({.name = "maximised", .help = "The window fills the screen."}),
          field<&WindowParams::left>({.name = "left",
                                      .help = "Width of the parameters, at the usual text size.",
                                      .unit = "px",
                                      .limits = {0, 32768}}),
          field<&WindowParams::right>({.name = "right",
                                       .help = "Width of the inspector, at the usual text size.",
                                       .unit = "px",
                                       .limits = {0, 32768}}),
          field<&WindowParams::bottom>({.name = "bottom",
                                        .help = "Height of timings and log, at the usual text size.",
                                        .unit = "px",
                                        .limits = {0, 32768}}),
          field<&WindowParams::show_left>({.name = "show_left", .help = "Show the parameters."}),
          field<&WindowParams::show_right>({.name = "show_right", .help = "Show the inspector."}),
          field<&WindowParams::show_bottom>({.name = "show_bottom", .help = "Show timings and log."}),
          field<&WindowParams::left_tab>({.name = "left_tab", .help = "What the panel on the left shows."}),
          field<&WindowParams::theme>({.name = "theme", .help = "Dark or light."}),
          field<&WindowParams::zoom>(
              {.name = "zoom", .help = "Size of text, on top of the desktop's.", .limits = {0.5, 3}}),
          field<&WindowParams::keys_page>(
              {.name = "keys_page", .help = "Show the page of keys at the start."}),
          field<&WindowParams::open_groups>(
              {.name = "open_groups", .help = "Groups of parameters that are open."}),
          field<&WindowParams::hidden_buffers>(
              {.name = "hidden_buffers", .help = "Buffers that the contact sheet leaves out."}),
      }};
  return kDescription;
}

bool has_word(const std::string& words, std::string_view word) {
  for (const std::string& one : split(words, ' ')) {
    if (one == word) return true;
  }
  return false;
}

std::string with_word(const std::string& words, std::string_view word, bool present) {
  std::vector<std::string> kept;
  for (const std::string& one : split(words, ' ')) {
    if (!one.empty() && one != word) kept.push_back(one);
  }
  if (present) kept.emplace_back(word);
  return join(kept, " ");
}

}  // namespace inkbench
