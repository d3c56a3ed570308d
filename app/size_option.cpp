// SPDX-License-Identifier: MIT
#include "app/size_option.h"

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {

void apply_size(Settings& settings, const std::string& text) {
  const std::string where = "--size " + text;
  const std::vector<std::string> sides = split(text, 'x');
  const auto is_number = [](const std::string& side) {
    return !side.empty() && side.size() < 10 && side.find_first_not_of("-0123456789") == std::string::npos;
  };
  if (sides.size() != 2 || !is_number(sides[0]) || !is_number(sides[1])) {
    throw input_error(where, "is not a size", "give it as WIDTHxHEIGHT in pixels, for example 1024x768");
  }
  set_param_text(settings, "image.width", sides[0], where);
  set_param_text(settings, "image.height", sides[1], where);
}

}  // namespace inkbench
