// SPDX-License-Identifier: MIT
// The camera and the lights of an imported scene as ours. In: the scene and the box around it. Out:
// parameters within their limits.
#pragma once

#include <vector>

#include "pipeline/mesh/formats/imported_scene.h"
#include "pipeline/mesh/formats/scene_box.h"
#include "pipeline/settings/camera.h"
#include "pipeline/settings/light.h"

namespace inkbench {

/// The file's first camera, or one that has the box in sight, from the front and a little above. Near and far
/// plane enclose the box. `aspect` is the image's, for files that do not say theirs.
CameraParams imported_camera(const ImportedScene& scene, const SceneBox& box, double aspect);

/// The file's lights, or one over the camera's left shoulder.
std::vector<LightParams> imported_lights(const ImportedScene& scene, const SceneBox& box,
                                         const CameraParams& camera);

}  // namespace inkbench
