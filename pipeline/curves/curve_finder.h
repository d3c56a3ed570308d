// SPDX-License-Identifier: MIT
// The curves of whole scenes from plain data, on any thread. In: the visible models' meshes, the camera. Out:
// their curves. What no view changes is kept from call to call.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/curves/object_curves.h"

namespace inkbench {

/// One visible model.
struct CurveRequestModel {
  std::shared_ptr<const Mesh> mesh;  ///< As it is drawn; never null.
  Key mesh_key;                      ///< Equal for equal meshes.
  glm::mat4 to_world{1.0F};
  int object_id = 0;
};

struct CurveRequest {
  std::vector<CurveRequestModel> models;
  CameraParams camera;
  CurvesParams params;
  int width_px = 0, height_px = 0;
};

class CurveFinder {
 public:
  /// One call at a time; others wait.
  Curves find(const CurveRequest& request);

 private:
  struct Placed {
    Key key;         ///< Of the source.
    Key placed_key;  ///< Of the source where it stands.
  };
  std::vector<Placed> make_sources(const CurveRequest& request);
  std::vector<ModelCuts> make_cuts(const CurveRequest& request, const std::vector<Placed>& placed);

  std::mutex mutex_;
  std::map<Key, std::unique_ptr<CurveSource>> sources_;
  std::map<Key, SurfaceCuts> cuts_;  ///< Between two models.
};

}  // namespace inkbench
