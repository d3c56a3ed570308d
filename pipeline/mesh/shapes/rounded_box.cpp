// SPDX-License-Identifier: MIT
// The rounded box: eight eighths of a sphere, twelve quarter cylinders between them and six flat sides. All
// share their border vertices, since the normal is continuous everywhere.
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {
namespace {

class RoundedBox {
 public:
  RoundedBox(int segments, float fillet) : segments_(segments), fillet_(fillet), core_(0.5 - fillet_) {}

  Mesh build() {
    for (int corner = 0; corner < 8; ++corner) add_corner_vertices(corner);
    for (int corner = 0; corner < 8; ++corner) add_corner_faces(corner);
    // With the largest fillet nothing lies between the corners, and the neighbours' borders are one.
    if (core_ > 0.0) {
      for (int axis = 0; axis < 3; ++axis) add_edges_along(axis);
      for (int axis = 0; axis < 3; ++axis) add_sides_across(axis);
    }
    return std::move(mesh_);
  }

 private:
  // Within a corner, row i of a triangular grid lies i steps from the y axis and has i + 1 vertices: no
  // triangle degenerates at the pole, and all three borders are divided evenly.

  /// Bits 0 to 2 of `corner` choose the negative half of x, y and z.
  static glm::dvec3 signs(int corner) {
    return {(corner & 1) != 0 ? -1.0 : 1.0, (corner & 2) != 0 ? -1.0 : 1.0, (corner & 4) != 0 ? -1.0 : 1.0};
  }

  /// Sine and cosine of `step` / `steps` of a right angle, exact at its ends so that flat sides are flat.
  static std::array<double, 2> sine_cosine(int step, int steps) {
    if (step == 0) return {0.0, 1.0};
    if (step == steps) return {1.0, 0.0};
    const double angle = 0.5 * std::numbers::pi * step / steps;
    return {std::sin(angle), std::cos(angle)};
  }

  static glm::dvec3 eighth_direction(int i, int j, int segments) {
    const auto [sin_polar, cos_polar] = sine_cosine(i, segments);
    const auto [sin_around, cos_around] = i == 0 ? std::array{0.0, 1.0} : sine_cosine(j, i);
    return {sin_polar * sin_around, cos_polar, sin_polar * cos_around};
  }

  void add_corner_vertices(int corner) {
    for (int i = 0; i <= segments_; ++i) {
      for (int j = 0; j <= i; ++j) corner_vertices_[corner].push_back(find_or_add(corner, i, j));
    }
  }

  /// A vertex on the plane between two corners of a full sphere belongs to the corner on the positive side.
  uint32_t find_or_add(int corner, int i, int j) {
    const glm::dvec3 normal = eighth_direction(i, j, segments_);
    int owner = corner;
    for (int axis = 0; axis < 3; ++axis) {
      if (core_ <= 0.0 && normal[axis] == 0.0) owner &= ~(1 << axis);
    }
    if (owner != corner) return at(owner, i, j);
    mesh_.positions.emplace_back(signs(corner) * (glm::dvec3(core_) + fillet_ * normal));
    mesh_.normals.emplace_back(signs(corner) * normal);
    return static_cast<uint32_t>(mesh_.positions.size() - 1);
  }

  uint32_t at(int corner, int i, int j) const {
    const int place = i * (i + 1) / 2 + j;
    return corner_vertices_[corner][static_cast<size_t>(place)];
  }

  /// The vertex `step` steps along the border of a corner on which the normal has no component along `axis`;
  /// both neighbours across that axis count alike.
  uint32_t border(int corner, int axis, int step) const {
    if (axis == 0) return at(corner, step, 0);
    if (axis == 1) return at(corner, segments_, step);
    return at(corner, step, step);
  }

  /// The vertex at which a corner's normal is along `axis`.
  uint32_t tip(int corner, int axis) const {
    if (axis == 0) return at(corner, segments_, segments_);
    if (axis == 1) return at(corner, 0, 0);
    return at(corner, segments_, 0);
  }

  /// Convex around the origin: outside is where the normals point.
  void add_outward(uint32_t a, uint32_t b, uint32_t c) {
    const glm::dvec3 origin = mesh_.positions[a];
    const glm::dvec3 facing =
        glm::cross(glm::dvec3(mesh_.positions[b]) - origin, glm::dvec3(mesh_.positions[c]) - origin);
    const glm::dvec3 outward = mesh_.normals[a] + mesh_.normals[b] + mesh_.normals[c];
    if (glm::dot(facing, outward) < 0.0) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  void add_outward_quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    add_outward(a, b, c);
    add_outward(a, c, d);
  }

  void add_corner_faces(int corner) {
    for (int i = 0; i < segments_; ++i) {
      for (int j = 0; j <= i; ++j) {
        add_outward(at(corner, i, j), at(corner, i + 1, j), at(corner, i + 1, j + 1));
        if (j < i) add_outward(at(corner, i, j), at(corner, i + 1, j + 1), at(corner, i, j + 1));
      }
    }
  }

  /// The four quarter cylinders along an axis.
  void add_edges_along(int axis) {
    for (int corner = 0; corner < 8; ++corner) {
      const int across = corner | 1 << axis;
      if (across == corner) continue;
      for (int step = 0; step < segments_; ++step) {
        add_outward_quad(border(corner, axis, step), border(across, axis, step),
                         border(across, axis, step + 1), border(corner, axis, step + 1));
      }
    }
  }

  /// The two flat sides across an axis.
  void add_sides_across(int axis) {
    const int right = 1 << (axis + 1) % 3;
    const int up = 1 << (axis + 2) % 3;
    for (const int side : {0, 1 << axis}) {
      add_outward_quad(tip(side, axis), tip(side | right, axis), tip(side | right | up, axis),
                       tip(side | up, axis));
    }
  }

  int segments_;
  double fillet_;
  double core_;
  Mesh mesh_;
  std::array<std::vector<uint32_t>, 8> corner_vertices_;
};

}  // namespace

Mesh make_rounded_box(int segments, float fillet) {
  assert(segments >= 1 && fillet >= 0.0F && fillet <= 0.5F);
  return fillet > 0.0F ? RoundedBox(segments, fillet).build() : make_box(segments);
}

}  // namespace inkbench
