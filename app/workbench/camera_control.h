// SPDX-License-Identifier: MIT
// Moving the camera and the lights with the mouse. Pure functions: parameters and cursor in, parameters out.
// Cursors are in px inside the shown image, x right, y down. A move that would leave the parameters' limits
// is not made, so what comes out is accepted by settings if what went in was.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "pipeline/mesh/mesh.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

struct ViewSize {
  float width_px = 1, height_px = 1;
};

/// How near to straight above or below the eye may come: at 90 degrees `up` would have no direction.
inline constexpr double kMaxElevationDeg = 89.9;

/// Turns the eye about the target, around the camera's `up` and then over it: positive yaw moves the eye to
/// the right, positive pitch up. Stops at the poles instead of flipping over them. Distance and `up` stay.
CameraParams orbit(const CameraParams& camera, double yaw_deg, double pitch_deg);

/// The same from a drag: the scene follows the cursor, half a turn for each height of the image.
CameraParams orbit_drag(const CameraParams& camera, const glm::vec2& from_px, const glm::vec2& to_px,
                        const ViewSize& size);

/// Moves eye and target in the image plane, so that what is under the cursor at the target's depth stays
/// under it.
CameraParams pan(const CameraParams& camera, const glm::vec2& from_px, const glm::vec2& to_px,
                 const ViewSize& size);

/// Moves the eye to (positive) or from the target, a tenth of the distance each step. Near and far stay,
/// since depth edges are relative to far: the target stays between twice near and 95 % of far. In
/// orthographic views `view_height` shrinks by as much, and the eye stays.
CameraParams dolly(const CameraParams& camera, double steps);

/// The same towards what is under the cursor at the target's depth, which stays under it.
CameraParams dolly_at(const CameraParams& camera, double steps, const glm::vec2& cursor_px,
                      const ViewSize& size);

/// Turns the view about the eye: positive yaw looks right, positive pitch up. Stops at the poles.
CameraParams look_around(const CameraParams& camera, double yaw_deg, double pitch_deg);

/// The eye at these angles about the target: azimuth 0 is on the side of +z (of +x where `up` is along z),
/// counter-clockwise seen from above; elevation 0 is level. (0, 0) is the front, (90, 0) the right side,
/// (0, 90) nearly straight above.
CameraParams view_from(const CameraParams& camera, double azimuth_deg, double elevation_deg);

/// The camera with the other way to project. What lies in the plane through the target keeps its place and
/// size in the image: an orthographic camera's `view_height` becomes what was seen there, and a perspective
/// one's eye goes to where as much is seen there, near and far with it where they would cut the target.
CameraParams with_projection(const CameraParams& camera, CameraProjection projection);

/// Keeps the direction of view, puts the target in the middle of the box and the eye as near as the whole box
/// is in sight (in orthographic views a diagonal away, with the least `view_height`); then `keep_in_range`.
/// An empty box is taken as one of side 1.
CameraParams fit_to_bounds(const CameraParams& camera, const Bounds& bounds, const ViewSize& size);

/// Moves near and far only as far as needed for the box to lie between them: a larger far makes all depth
/// edges weaker. The eye of an orthographic view first steps back until the whole box is before it.
CameraParams keep_in_range(const CameraParams& camera, const Bounds& bounds);

/// A light's direction after a drag over the image as over a ball that fills it: the side of the ball that
/// faces the eye follows the cursor. Of unit length. Source: Bell's trackball (a sphere that runs into a
/// hyperbola, so that nothing jumps at its rim).
glm::vec3 drag_light(const glm::vec3& direction, const CameraParams& camera, const glm::vec2& from_px,
                     const glm::vec2& to_px, const ViewSize& size);

}  // namespace inkbench
