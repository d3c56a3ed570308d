// SPDX-License-Identifier: MIT
// A triangle mesh as the passes draw it, and what was noticed when it was made. A vertex is a place with a
// normal; vertices at one place are one point of the surface, whose edges and shape know no normals.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace inkbench {

struct Mesh {
  std::vector<glm::vec3> positions;  ///< Of V vertices, in the mesh's own units, all finite.
  std::vector<glm::vec3> normals;    ///< V unit vectors.
  std::vector<std::array<uint32_t, 3>>
      triangles;  ///< F triples of indices below V, counter-clockwise from outside.
  /// What was taken out of the file's coordinates before they became floats: a point of the file stands at
  /// origin + unit * position. Mostly 0 and 1.
  glm::dvec3 origin{0.0};
  double unit = 1.0;
  bool has_given_normals = false;  ///< They come from the file or the shape, not from the faces.
  std::vector<std::string> notes;  ///< What the loader dropped or computed, one sentence each.
};

struct Bounds {
  glm::vec3 low{0.0F};
  glm::vec3 high{0.0F};
  glm::dvec3 origin{0.0};  ///< The mesh's, and its unit.
  double unit = 1.0;
};

/// The axis-aligned box around the points that triangles use; without triangles, the origin.
Bounds bounds_of(const Mesh& mesh);

/// No component is NaN or infinite.
bool is_finite(const glm::vec3& v);

}  // namespace inkbench
