// SPDX-License-Identifier: MIT
// Places of files as they stand in other files, where "%20" means a blank.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

namespace inkbench {

/// "wheel%20left.bin" is "wheel left.bin"; what is no escape stays as it is.
inline std::string without_escapes(std::string_view place) {
  std::string text;
  for (size_t i = 0; i < place.size(); ++i) {
    unsigned code = 0;
    const char* const digits = place.data() + i + 1;
    const bool is_escape = place[i] == '%' && i + 2 < place.size() &&
                           std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    text.push_back(is_escape ? static_cast<char>(code) : place[i]);
    if (is_escape) i += 2;
  }
  return text;
}

}  // namespace inkbench
