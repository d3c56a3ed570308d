// SPDX-License-Identifier: MIT
// Where a surface is flat to within a pixel's size, whatever its slant.
#include <algorithm>
#include <cmath>

#include "pipeline/passes/edges/edge_class.h"
#include "pipeline/passes/edges/operators.h"
#include "studies/judging/cause_finder.h"

namespace inkbench {
namespace {

/// `affine_depth` of an image, and planes in it.
class AffineDepth {
 public:
  AffineDepth(const Image& depth, const CameraParams& camera)
      : depth_(depth),
        lens_(lens_of(camera, depth.height_px)),
        is_ortho_(is_orthographic(camera)),
        delta_(pixel_size(camera, 1.0, depth.height_px)) {}

  bool is_inside(int x, int y) const { return is_inside_image(depth_, x, y); }
  bool is_background(int x, int y) const { return inkbench::is_background(depth_.at(x, y)); }
  double at(int x, int y) const { return affine_depth(lens_, depth_.at(x, y)); }

  struct Plane {
    double here, a, b;  ///< The value at the pixel, and its change a pixel to the right and down.
    double steepness;   ///< Length of the plane's normal, by which distances are divided.
  };
  Plane plane_at(int x, int y) const {
    Plane plane{at(x, y), slope(x, y, 1, 0), slope(x, y, 0, 1), 0};
    const double to_middle_x = 0.5 * depth_.width_px - x - 0.5,
                 to_middle_y = 0.5 * depth_.height_px - y - 0.5;
    const double middle = is_ortho_ ? 1.0 : plane.here + plane.a * to_middle_x + plane.b * to_middle_y;
    plane.steepness = std::hypot(plane.a, plane.b, delta_ * middle);
    return plane;
  }

  /// From the plane at (x, y) to what is seen dx and dy away, in sizes of the plane's pixel.
  double distance(const Plane& plane, int x, int y, int dx, int dy) const {
    const double there = at(x + dx, y + dy);
    const double off = std::abs(there - plane.here - dx * plane.a - dy * plane.b) / plane.steepness;
    return is_ortho_ ? off : off * plane.here / there;
  }

 private:
  /// The smaller one of the differences to both neighbours, of those that are there.
  double slope(int x, int y, int dx, int dy) const {
    double least = 0;
    bool any = false;
    for (const int side : {-1, 1}) {
      const int other_x = x + side * dx, other_y = y + side * dy;
      if (!is_inside(other_x, other_y) || is_background(other_x, other_y)) continue;
      const double change = side * (at(other_x, other_y) - at(x, y));
      if (any && std::abs(change) >= std::abs(least)) continue;
      least = change;
      any = true;
    }
    return least;
  }

  const Image& depth_;
  LensBlock lens_;
  bool is_ortho_;
  double delta_;
};

bool is_even(const AffineDepth& depth, int x, int y, int reach_px) {
  if (depth.is_background(x, y)) return false;
  const AffineDepth::Plane plane = depth.plane_at(x, y);
  for (int dy = -reach_px; dy <= reach_px; ++dy) {
    for (int dx = -reach_px; dx <= reach_px; ++dx) {
      if (!depth.is_inside(x + dx, y + dy)) continue;
      if (depth.is_background(x + dx, y + dy) || depth.distance(plane, x, y, dx, dy) > 1.0) return false;
    }
  }
  return true;
}

}  // namespace

LineMap even_pixels(const Image& depth, const CameraParams& camera, int reach_px) {
  LineMap even(depth.width_px, depth.height_px);
  const AffineDepth affine(depth, camera);
  for (int y = 0; y < depth.height_px; ++y) {
    for (int x = 0; x < depth.width_px; ++x) even.set(x, y, is_even(affine, x, y, reach_px));
  }
  return even;
}

}  // namespace inkbench
