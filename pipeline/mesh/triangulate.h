// SPDX-License-Identifier: MIT
// Polygons to triangles, as a fan.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace inkbench {

/// Appends the triangles of one polygon (indices into `points`, all in range and finite), leaving out those
/// without area. The fan starts where every triangle faces the polygon's way, if there is such a corner: that
/// keeps corners in the middle of a side and gets concave quads right. False where the polygon has no area.
bool triangulate(std::span<const glm::vec3> points, std::span<const int32_t> polygon,
                 std::vector<std::array<uint32_t, 3>>& triangles);

}  // namespace inkbench
