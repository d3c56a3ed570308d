// SPDX-License-Identifier: MIT
// Where a mesh is seen from, in its own space: a point or, in orthographic views, a direction. In: the
// camera's eye or the way back from what it looks at. Out: the way from a point of the mesh towards it.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace inkbench {

class Viewpoint {
 public:
  Viewpoint(const glm::dvec3& eye) : place_(eye) {}
  Viewpoint(double x, double y, double z) : place_(x, y, z) {}
  /// Infinitely far away, in this direction, which need not be of unit length.
  static Viewpoint at_infinity(const glm::dvec3& direction) {
    Viewpoint viewpoint(direction);
    viewpoint.is_direction_ = true;
    return viewpoint;
  }

  /// From a point towards the eye, of any length.
  glm::dvec3 from(const glm::dvec3& point) const { return is_direction_ ? place_ : place_ - point; }
  bool is_at_infinity() const { return is_direction_; }
  /// The same in a space that `matrix` leads to.
  Viewpoint in(const glm::dmat3& matrix) const {
    Viewpoint viewpoint = *this;
    viewpoint.place_ = matrix * place_;
    return viewpoint;
  }

 private:
  glm::dvec3 place_;
  bool is_direction_ = false;
};

}  // namespace inkbench
