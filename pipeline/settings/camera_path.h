// SPDX-License-Identifier: MIT
// A camera path: how the camera moves over the frames of a turn. In: a scene's settings. Out: the settings
// of frame i. Described once for whatever runs along one: studies, image sequences, films.
#pragma once

#include <string>

#include "pipeline/params/toml_document.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// An orbit about the camera's target. Lights and models stay where they are.
struct CameraPath {
  int frames = 180;
  glm::vec3 axis{0.0F, 1.0F, 0.0F};
  float degrees = 360.0F;

  static const Description& description();
};

/// Where a path says nothing of its degrees, so many lie between two frames.
inline constexpr int kDegreesPerFrame = 2;

/// How far frame `frame` (from 0) is turned: `frame` / `frames` of the path's degrees. So a whole turn ends
/// one step before its first frame, and a film of it loops.
double degrees_at(const CameraPath& path, int frame);

/// The camera turned as a rigid body, `up` with it, counter-clockwise as seen from the axis' tip. Frame 0 is
/// the camera itself, to the bit.
CameraParams camera_at(const CameraPath& path, const CameraParams& camera, int frame);

/// The settings with the camera of that frame. Errors (input): it is farther out than a camera may be.
Settings settings_at(const CameraPath& path, const Settings& settings, int frame);

/// The table [path] of a document; `name` stands for the document in errors. Errors (input), with file and
/// line: unknown keys with the nearest one, values that a field does not accept, an axis of no length.
CameraPath read_path(const TomlNode& table, const std::string& name);

}  // namespace inkbench
