// SPDX-License-Identifier: MIT
// Flat areas of polygons, and what is made of several. Clipper (libpolyclipping) does the work, on a grid of
// 1/16384 of the unit.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace inkbench {

/// Corners in order, 3 or more; the last one goes on to the first.
using Ring = std::vector<glm::dvec2>;

/// Of a flat area: what the rings go round more often in one direction than in the other lies in it. Holes
/// run against what they are holes of.
using Outline = std::vector<Ring>;

/// Round what lies in any of the rings, which all run in one direction or come from outlines: rings that
/// neither cross themselves nor each other, each outer one before its holes, in an order that the input's
/// order decides. At most 60,000 units from 0.
Outline united(const std::vector<Ring>& rings);

/// Round what lies in the outline and not in the other one.
Outline without(const Outline& outline, const Outline& other);

/// Each part that hangs together, with its holes; of one that `united` or `without` gave.
std::vector<Outline> parts_of(const Outline& outline);

/// Of what lies in the outline, in square units; of one that `united` or `without` gave.
double area(const Outline& outline);

}  // namespace inkbench
