// SPDX-License-Identifier: MIT
// A ray caster over exact shapes in double precision: what the G-buffer should hold at each pixel's centre
// (3.4.1, 3.4.2). In: the settings' camera and models (no mesh files). Out: normal, depth and id maps.
#pragma once

#include <glm/vec3.hpp>

#include "pipeline/settings/settings.h"
#include "tests/gl/cpu_reference.h"

namespace inkbench::reference {

struct Surface {
  Map normal;     ///< H x W x 3: 0.5 N + 0.5 in world space, 0.5 where nothing is.
  Map depth;      ///< H x W x 1: distance along the view axis / far, 1 where nothing is.
  Map object_id;  ///< H x W x 1: place in the list of models from 1 on, 0 where nothing is.
};

/// The ray through the centre of a pixel, one unit long along the view axis; row 0 is the top one.
glm::dvec3 pixel_ray(const CameraParams& camera, int x, int y, int width_px, int height_px);

/// Where that ray starts, in the plane through the eye: the eye itself in perspective views.
glm::dvec3 pixel_eye(const CameraParams& camera, int x, int y, int width_px, int height_px);

/// px to the right and down to where a point of the world is seen, and its distance along the view axis.
glm::dvec3 seen_at(const Settings& settings, const glm::dvec3& world);

/// Boxes, spheres (also inside out) and planes, exactly, between the near and the far plane.
Surface cast_rays(const Settings& settings);

/// H x W x 1: not 0 within 1 px of a change of object or a crease, where one pixel's centre decides between
/// two surfaces and a tessellated shape may differ from the exact one.
ImageOf<uint8_t> outlines(const Surface& surface);

}  // namespace inkbench::reference
