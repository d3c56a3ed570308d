// SPDX-License-Identifier: MIT
// A model where it stands: what the G-buffer and the wireframe draw.
#pragma once

#include <glm/mat4x4.hpp>
#include <string>

#include "pipeline/passes/gbuffer/gpu_mesh.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

/// One model to draw.
struct DrawItem {
  const GpuMesh* mesh = nullptr;
  glm::mat4 model_to_world{1.0F};
  int object_id = 0;
  bool two_sided = true;
  std::string name;  ///< The model's.
};

/// How far a point is outside a box; 0 within it.
double distance_outside(const Bounds& box, const glm::vec3& point);

/// The distance along the view axis of the box's corner that lies least far along it; below 0 behind the eye.
double nearest_along_view(const Bounds& box, const CameraParams& camera);

/// The box in world space around the box of the item's mesh.
Bounds bounds_in_world(const DrawItem& item);

}  // namespace inkbench
