// SPDX-License-Identifier: MIT
#include "app/workbench/place_in_text.h"

#include <cctype>

#include "pipeline/base/files.h"

namespace inkbench {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// What can stand before a file's name or behind its line.
bool is_border(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0 || c == '"' || c == '\'' || c == '(' || c == ')';
}

}  // namespace

std::string place_in_text(std::string_view text) {
  for (size_t colon = text.find(':'); colon != std::string_view::npos; colon = text.find(':', colon + 1)) {
    size_t end = colon + 1;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end == colon + 1) continue;
    size_t begin = colon;
    while (begin > 0 && !is_border(text[begin - 1])) --begin;
    const std::string_view file = text.substr(begin, colon - begin);
    // A name with an ending and no other colon: not a time, nor an address.
    const size_t dot = file.rfind('.');
    const bool is_file = dot != std::string_view::npos && dot > 0 && dot + 1 < file.size() &&
                         !is_digit(file[dot + 1]) && file.find(':') == std::string_view::npos;
    if (is_file) return std::string(text.substr(begin, end - begin));
  }
  return "";
}

std::string whole_place(const std::string& place) {
  const size_t colon = place.rfind(':');
  const fs::path file = place.substr(0, colon);
  if (colon == std::string::npos || file.is_absolute()) return place;
  try {
    for (const fs::path& folder : {project_root(), fs::current_path()}) {
      std::error_code error;
      if (fs::exists(folder / file, error)) return (folder / file).string() + place.substr(colon);
    }
  } catch (const std::exception&) {  // no such folder: the name alone
  }
  return place;
}

}  // namespace inkbench
