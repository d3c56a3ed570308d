// SPDX-License-Identifier: MIT
// The small parts of SVG files: texts, numbers, colours, path data. The same input gives the same bytes.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/vectors/cubic_path.h"

namespace inkbench {

/// For elements and quoted attributes; what XML cannot hold is spelt out (`printable`).
std::string xml_text(std::string_view text);

/// As a part of an id: what is no letter, digit, `_`, `-` or `.` of ASCII becomes `_`.
std::string id_part(std::string_view name);

/// With so many digits after the point at most: "1.5", "-.25", "0".
std::string svg_number(double value, int digits);

/// "#1a2b3c" of components from 0 to 1, others taken to the nearer end.
std::string svg_colour(const glm::vec3& colour);

/// For `d`, as few characters as that takes: coordinates on a grid of 10^-digits, steps relative, so that
/// nothing is off by more than sqrt(1/2) of a step of the grid. Paths that are a point there are left out.
std::string path_data(std::span<const CubicPath> paths, int digits);

}  // namespace inkbench
