// SPDX-License-Identifier: MIT
// The values a parameter can hold, and their one text form (TOML syntax, shortest round-trip numbers), which
// is what files, `--set`, study keys, image metadata and cache keys all use.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

namespace inkbench {

/// One stop of a ramp: at `position` (0 to 1) the ramp has `colour`; it holds it to the next stop (stepped)
/// or blends linearly into the next one (smooth).
struct RampStop {
  float position = 0.0F;
  glm::vec3 colour{0.0F};
  bool stepped = true;
  bool operator==(const RampStop&) const = default;
};

/// A lighting ramp (3.2): stops in rising order of position, or the first row of an image file.
struct Ramp {
  std::vector<RampStop> stops;
  std::string image;  ///< Path of an image file; when not empty it is used instead of the stops.
  bool operator==(const Ramp&) const = default;
};

/// A choice among names is held as its name (std::string).
using Value = std::variant<bool, int, float, glm::vec3, std::string, Ramp>;

/// TOML text of a value: `true`, `7`, `0.003`, `[0, 1, 0]`, `"box"`, `[{position = 0, ...}, ...]`.
std::string to_text(const Value& value);

}  // namespace inkbench
