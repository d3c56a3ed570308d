// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/edge_class.h"

#include <algorithm>
#include <cmath>

#include "pipeline/passes/edges/operators.h"

namespace inkbench {
namespace {

/// Eight bits round what is close to the camera to 0.
constexpr double kLeastDepth = 1e-12;
/// A bend of so many pixel sizes can be seen as a crease.
constexpr double kLeastBend = 0.2;

/// Between `b` and `c` of four values in a row: how far each lies from the other side's plane, the smaller
/// one.
double step_between(const LensBlock& lens, double a, double b, double c, double d) {
  const double slope_b = in_pixel_sizes(lens, b - a, b), slope_c = in_pixel_sizes(lens, d - c, c);
  return std::min(in_pixel_sizes(lens, a - 2 * b + c, b) / std::sqrt(1 + slope_b * slope_b),
                  in_pixel_sizes(lens, b - 2 * c + d, c) / std::sqrt(1 + slope_c * slope_c));
}

/// What is seen from a pixel up to `reach` pixels away.
struct Seen {
  bool other_id = false, other_ground = false;
  double step_px = 0, bend_px = 0;
};

void look(const SurfaceMaps& maps, const LensBlock& lens, int x, int y, Offset to, int reach, Seen& seen) {
  const auto nearest = [&](const Image& map, int steps) -> double {
    return map.at(std::clamp(x + steps * to.dx, 0, map.width_px - 1),
                  std::clamp(y + steps * to.dy, 0, map.height_px - 1));
  };
  const auto inside = [&](int steps) {
    return is_inside_image(*maps.depth, x + steps * to.dx, y + steps * to.dy);
  };
  for (int k = 1; k <= reach; ++k) {
    double depth[4], affine[4];
    for (int i = 0; i < 4; ++i) {
      depth[i] = nearest(*maps.depth, k - 2 + i);
      affine[i] = affine_depth(lens, depth[i]);
    }
    const auto [a, b, c, d] = affine;
    seen.other_id = seen.other_id || nearest(*maps.object_id, k) != nearest(*maps.object_id, 0);
    seen.other_ground = seen.other_ground || is_background(depth[2]) != is_background(depth[1]);
    if (!inside(k - 2) || is_background(depth[1])) continue;
    seen.bend_px = std::max(seen.bend_px, in_pixel_sizes(lens, a - 2 * b + c, b));
    if (!inside(k + 1) || is_background(depth[2])) continue;
    seen.step_px = std::max(seen.step_px, step_between(lens, a, b, c, d));
  }
}

}  // namespace

double affine_depth(const LensBlock& lens, double depth) {
  if (lens.is_orthographic != 0) return depth * lens.far;
  return is_background(depth) ? 0.0 : 1 / (std::max(depth, kLeastDepth) * lens.far);
}

double in_pixel_sizes(const LensBlock& lens, double second_difference, double here) {
  const double unit = lens.is_orthographic != 0 ? lens.pixel_size : here * lens.pixel_size;
  return std::abs(second_difference) / unit;
}

EdgeClass edge_class(const SurfaceMaps& maps, const LensBlock& lens, int x, int y, int reach) {
  Seen seen;
  for (int i = 0; i < 9; ++i) {
    if (i != 4) look(maps, lens, x, y, {i % 3 - 1, i / 3 - 1}, reach, seen);
  }
  if (seen.other_id) return EdgeClass::object;
  if (seen.step_px > 1 || seen.other_ground) return EdgeClass::silhouette;
  return seen.bend_px > kLeastBend ? EdgeClass::crease : EdgeClass::normal;
}

std::string class_name(EdgeClass edge_class) {
  return edge_class == EdgeClass::none ? "" : std::string(kEdgeClassNames[static_cast<size_t>(edge_class)]);
}

}  // namespace inkbench
