// SPDX-License-Identifier: MIT
// Lines from a mesh's space to the image. In: points and camera. Out: the parts inside the view, in pixel
// space, with 1 / z or z.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "pipeline/lines/viewpoint.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

/// x and y in px (x right, y down, pixel centres at + 0.5), and w = 1 / z with z = the distance along the
/// view axis; in orthographic views z itself. So all three are linear along a projected straight line. A
/// closed line repeats its first point.
using ProjectedLine = std::vector<glm::dvec3>;

inline bool is_closed(const ProjectedLine& line) {
  return line.size() > 2 && line.front() == line.back();
}

class Projection {
 public:
  /// The matrices that the renderer uses, from the mesh's space on.
  Projection(const CameraParams& camera, int width_px, int height_px, const glm::mat4& model_to_world);

  /// The eye in the mesh's space, or the direction towards it.
  const Viewpoint& viewpoint() const { return viewpoint_; }
  /// Whether the mesh is shown inside out.
  bool mirrored() const { return mirrored_; }

  /// The parts between the near and the far plane and inside the image. What lies outside is cut off, so one
  /// line may become several; a closed line that is cut starts at a cut.
  std::vector<ProjectedLine> project(std::span<const glm::dvec3> points) const;

 private:
  glm::dvec3 to_pixel(const glm::dvec4& clip) const;

  double width_px_, height_px_;
  glm::dmat4 projection_, to_clip_;
  bool is_orthographic_;
  Viewpoint viewpoint_;
  bool mirrored_;
};

}  // namespace inkbench
