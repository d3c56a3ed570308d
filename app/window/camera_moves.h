// What the mouse does to a camera: around its target, along the picture, nearer and farther.
#pragma once

#include "pipeline/scene/camera.h"

namespace inkbench {

/// Around the target: to the right and upwards by so many degrees; never over the pole.
CameraParams orbited(const CameraParams& camera, double right_deg, double up_deg);

/// Eye and target along the picture, so that what is at the target's distance moves to the right and down by
/// these shares of the picture's height.
CameraParams panned(const CameraParams& camera, double right, double down);

/// The distance to the target times `factor`, but not through the near plane.
CameraParams dollied(const CameraParams& camera, double factor);

}  // namespace inkbench
