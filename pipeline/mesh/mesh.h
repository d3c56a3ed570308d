// SPDX-License-Identifier: MIT
// A triangle mesh as the passes draw it, and what was noticed when it was made.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace inkbench {

struct Mesh {
  std::vector<glm::vec3> positions;  ///< V points, in the mesh's own units, all finite.
  std::vector<glm::vec3> normals;    ///< V unit vectors, one for each point.
  std::vector<std::array<uint32_t, 3>>
      triangles;                   ///< F triples of indices below V, counter-clockwise from outside.
  std::vector<std::string> notes;  ///< What the loader dropped or computed, one sentence each.
};

struct Bounds {
  glm::vec3 low{0.0F};
  glm::vec3 high{0.0F};
};

/// The axis-aligned box around the points that triangles use; without triangles, the origin.
Bounds bounds_of(const Mesh& mesh);

/// No component is NaN or infinite.
bool is_finite(const glm::vec3& v);

}  // namespace inkbench
