// SPDX-License-Identifier: MIT
// The front of the reference lines: scene, camera and the pipeline's depth and object-id buffers in; visible
// polylines of all classes out, as docs/reference-lines.md defines them.
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "pipeline/image/image.h"
#include "pipeline/lines/features.h"
#include "pipeline/lines/line_map.h"
#include "pipeline/lines/lines.h"
#include "pipeline/lines/topology.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

/// One visible model of the scene.
struct SceneMesh {
  const MeshTopology* topology = nullptr;  ///< Of the mesh that is drawn: silhouettes and boundaries.
  glm::mat4 model_to_world{1.0F};
  int object_id = 0;
  /// Of the full-resolution mesh in the same space: creases and tier 2. Null: neither.
  const MeshFeatures* features = nullptr;
};

struct ReferenceLines {
  int width_px = 0, height_px = 0;
  /// Each mesh edge in one line at most: a crease along an edge that is a silhouette or boundary is given as
  /// that. Ordered by object, then class; `object` lines last.
  std::vector<Polyline> polylines;
  /// All creases, those along silhouettes and boundaries included: what the class's own map shows.
  std::vector<Polyline> whole_creases;
};

/// `depth` and `object_id`: the pipeline's raw buffers in float precision for the same camera and models,
/// each H x W x 1, row 0 on top. Deterministic.
ReferenceLines reference_lines(std::span<const SceneMesh> scene, const CameraParams& camera,
                               const Image& depth, const Image& object_id);

/// Sets the pixels of a line: those that hold its samples, every 0.5 px from its start, and its end; a sample
/// on the border between two pixels belongs to the one with the larger coordinate.
void draw_line(const Polyline& line, LineMap& map);

/// All lines of a class. A pixel may be in the maps of several classes.
LineMap class_map(const ReferenceLines& lines, LineClass line_class);

/// The maps of the tier's classes united; `tier` is 1 or 2.
LineMap tier_map(const ReferenceLines& lines, const JudgeParams& judge, int tier);

}  // namespace inkbench
