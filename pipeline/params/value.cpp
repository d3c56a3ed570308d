// SPDX-License-Identifier: MIT
#include "pipeline/params/value.h"

#include <fmt/format.h>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

std::string vector_text(const glm::vec3& v) {
  return "[" + shortest(v.x) + ", " + shortest(v.y) + ", " + shortest(v.z) + "]";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      result += fmt::format("\\u{:04x}", byte);
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string ramp_text(const Ramp& ramp) {
  if (!ramp.image.empty()) return quoted(ramp.image);
  std::vector<std::string> stops;
  for (const RampStop& stop : ramp.stops) {
    stops.push_back(fmt::format("{{position = {}, colour = {}, stepped = {}}}", shortest(stop.position),
                                vector_text(stop.colour), stop.stepped));
  }
  return "[" + join(stops, ", ") + "]";
}

struct Writer {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(int value) const { return std::to_string(value); }
  std::string operator()(float value) const { return shortest(value); }
  std::string operator()(const glm::vec3& value) const { return vector_text(value); }
  std::string operator()(const std::string& value) const { return quoted(value); }
  std::string operator()(const Ramp& value) const { return ramp_text(value); }
};

}  // namespace

std::string to_text(const Value& value) {
  return std::visit(Writer{}, value);
}

}  // namespace inkbench
