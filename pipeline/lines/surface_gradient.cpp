// SPDX-License-Identifier: MIT
#include "pipeline/lines/surface_gradient.h"

#include "pipeline/lines/face_shape.h"

namespace inkbench {

glm::dvec3 gradient_on_face(const SmoothSurface& surface, uint32_t face, const glm::dvec3& scalar) {
  const FaceShape shape = shape_of(surface, surface.faces[face]);
  const double squared = glm::dot(shape.normal, shape.normal);
  if (!(squared > 0.0)) return glm::dvec3(0.0);
  const glm::dvec3 along =
      scalar[0] * shape.edges[1] + scalar[1] * shape.edges[2] + scalar[2] * shape.edges[0];
  return glm::cross(shape.normal, along) / squared;
}

glm::dvec3 gradient_at_point(const SmoothSurface& surface, const std::vector<double>& scalar,
                             uint32_t point) {
  glm::dvec3 gradient(0.0);
  double areas = 0.0;
  for (uint32_t i = surface.face_starts[point]; i < surface.face_starts[point + 1]; ++i) {
    const std::array<uint32_t, 3>& face = surface.faces[surface.point_faces[i]];
    const FaceShape shape = shape_of(surface, face);
    const double area = glm::length(shape.normal);
    if (!(area > 0.0)) continue;
    const glm::dvec3 along = scalar[face[0]] * shape.edges[1] + scalar[face[1]] * shape.edges[2] +
                             scalar[face[2]] * shape.edges[0];
    gradient += glm::cross(shape.normal, along) / area;
    areas += area;
  }
  return gradient / (areas > 0.0 ? areas : 1.0);
}

}  // namespace inkbench
