// SPDX-License-Identifier: MIT
// How large an imported scene is and where it lies, and bringing one that lies far away or is very large or
// small to where cameras and lights can follow.
#pragma once

#include <glm/vec3.hpp>

#include "pipeline/mesh/formats/imported_scene.h"

namespace inkbench {

struct SceneBox {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};

  glm::dvec3 middle() const { return (low + high) / 2.0; }
  double radius() const;
};

/// Around all points that faces use and that are finite; without any, the origin.
SceneBox box_of(const ImportedScene& scene);

/// Moves the scene's middle to the origin where it is more than a hundred times its size or 500,000 away, and
/// scales it by a power of ten, to a size of 1 to 10, where it is smaller than 0.0001 or larger than 200,000;
/// each with a note. Cameras and lights follow.
void bring_into_reach(ImportedScene& scene);

}  // namespace inkbench
