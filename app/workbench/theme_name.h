// The window's two looks, by name; theme.h has the colours.
#pragma once

#include "pipeline/params/description.h"

namespace inkbench {

enum class ThemeName { dark, light };
template <>
struct ChoiceNames<ThemeName> {
  static constexpr std::array<std::string_view, 2> names{"dark", "light"};
};

}  // namespace inkbench
