// SPDX-License-Identifier: MIT
// One polygon to triangles, by ear clipping. In: its corners in space. Out: triangles between them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace inkbench {

enum class Triangulation {
  clean,    ///< The triangles cover the polygon, each part once.
  crossed,  ///< The polygon crosses itself: triangles lie over each other or face the other way.
  no_area   ///< None: all corners on a line, or fewer than three.
};

/// Appends triangles of corner numbers, turning as the polygon does and each with an area. The corners are
/// finite; they need not lie in a plane, and two may be at one place, as where a bridge joins a hole to the
/// outline. A corner in the middle of a side is a corner of a triangle too, so that neighbours meet there.
/// No corner of a convex polygon of n gets more than about 2 log2(n) triangles. Ear clipping after Meisters
/// 1975; time n log n for usual outlines, n^2 at worst.
Triangulation triangulate(std::span<const glm::dvec3> corners,
                          std::vector<std::array<uint32_t, 3>>& triangles);

}  // namespace inkbench
