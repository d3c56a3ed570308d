// SPDX-License-Identifier: MIT
// The reference lines of whole scenes from plain data, on any thread. In: the visible models' meshes, the
// camera, the depth and object ids that the pipeline drew. Out: the visible lines. What no view changes is
// kept from call to call.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/base/stop.h"
#include "pipeline/lines/features.h"
#include "pipeline/lines/reference_lines.h"
#include "pipeline/lines/topology.h"
#include "pipeline/settings/model.h"

namespace inkbench {

/// One visible model. Meshes are never null; they are one where the full mesh is drawn.
struct LineModel {
  ModelParams params;
  int object_id = 0;
  std::shared_ptr<const Mesh> full, drawn;
  Key full_key, drawn_key;  ///< Equal for equal meshes; `full_key` of the scale and the judge as well.
};

struct LineRequest {
  Key key;  ///< Of all that decides the lines.
  std::vector<LineModel> models;
  CameraParams camera;
  JudgeParams judge;
  Image depth, object_id;  ///< As `reference_lines` takes them.
};

class LineFinder {
 public:
  /// One call at a time; others wait. Throws `Stopped` between models once `stop` says so.
  ReferenceLines find(const LineRequest& request, const StopAsked& stop = {});

 private:
  struct FullMesh {
    Bounds bounds;
    MeshFeatures features;
  };
  struct Part {
    const FullMesh* full;
    const MeshTopology* drawn;
  };
  Part part(const LineModel& model, const JudgeParams& judge);
  void free_unused(const LineRequest& request);

  std::mutex mutex_;
  std::map<Key, FullMesh> full_;
  std::map<Key, MeshTopology> drawn_;
};

}  // namespace inkbench
