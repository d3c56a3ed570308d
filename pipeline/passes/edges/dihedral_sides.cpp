// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/dihedral_sides.h"

#include <algorithm>
#include <cmath>

namespace inkbench {
namespace {

// Those of shaders/lib/pair_map.glsl.
constexpr double kLargestGap = 49152.0, kMeetingGap = 1.0 / 256.0;

PixelSide side_of(double angle, double gap, double sign, const DihedralParams& params, double weak) {
  const double apart = std::abs(gap);
  const bool meets = apart <= kMeetingGap;
  const double step_strength = meets ? 0.0 : apart / params.gap;
  const bool is_step = step_strength >= weak;
  const EdgeClass bend = params.normals == BendNormals::shading ? EdgeClass::normal : EdgeClass::crease;
  const double share = std::min(apart / kMeetingGap, 1.0);
  PixelSide side{.angle_deg = std::abs(angle), .gap_px = meets ? 0.0 : apart};
  side.is_object_border = apart > kLargestGap;
  side.is_own = (is_step ? gap : angle) * sign > 0.0;
  side.strength = std::max(side.angle_deg / params.angle, step_strength);
  side.meets_at = sign > 0.0 ? share : 1.0 - share;
  side.line_class = side.is_object_border ? EdgeClass::object : is_step ? EdgeClass::silhouette : bend;
  return side;
}

}  // namespace

std::array<PixelSide, 4> pixel_sides(const Image& angles, const Image& gaps, const DihedralParams& params,
                                     double weak, int x, int y) {
  constexpr std::array<Offset, 4> kNeighbours{{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};
  std::array<PixelSide, 4> sides;
  for (int i = 0; i < 4; ++i) {
    const Offset to = kNeighbours[i];
    const bool is_pixels_pair = i < 2;
    const int from_x = is_pixels_pair ? x : x + to.dx, from_y = is_pixels_pair ? y : y + to.dy;
    const bool inside = from_x >= 0 && from_y < angles.height_px;
    if (inside)
      sides[i] = side_of(angles.at(from_x, from_y, i % 2), gaps.at(from_x, from_y, i % 2),
                         is_pixels_pair ? 1.0 : -1.0, params, weak);
    sides[i].to = to;
  }
  return sides;
}

}  // namespace inkbench
