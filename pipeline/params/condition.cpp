// SPDX-License-Identifier: MIT
#include "pipeline/params/condition.h"

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

std::vector<std::string> parts_between(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  while (true) {
    const size_t place = text.find(separator);
    parts.emplace_back(text.substr(0, place));
    if (place == std::string_view::npos) return parts;
    text.remove_prefix(place + separator.size());
  }
}

}  // namespace

std::vector<Condition> parse_conditions(std::string_view text) {
  std::vector<Condition> conditions;
  if (text.empty()) return conditions;
  for (const std::string& part : parts_between(text, " and ")) {
    const bool is_unequal = part.find(" != ") != std::string::npos;
    const std::string_view sign = is_unequal ? " != " : " = ";
    const size_t place = part.find(sign);
    if (place == std::string::npos)
      throw input_error("condition", "'" + part + "' compares nothing", "for example \"use_depth = true\"");
    conditions.push_back({part.substr(0, place),
                          parts_between(std::string_view(part).substr(place + sign.size()), " or "),
                          is_unequal});
  }
  return conditions;
}

}  // namespace inkbench
