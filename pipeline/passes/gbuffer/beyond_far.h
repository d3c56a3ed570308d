// SPDX-License-Identifier: MIT
// Models that the far plane hides as a whole: an empty picture that says nothing would look like a fault of the
// mesh. In: camera and what is drawn. Out: a note in the log when a model goes beyond the far plane.
#pragma once

#include <set>
#include <span>

#include "pipeline/passes/gbuffer/draw_item.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

/// Every corner of the item's box is farther along the view axis than `camera.far`.
bool is_beyond_far(const DrawItem& item, const CameraParams& camera);

class BeyondFarNotes {
 public:
  /// One note for each model that is beyond the far plane and was not the time before.
  void update(std::span<const DrawItem> items, const CameraParams& camera);

 private:
  std::set<int> beyond_;  ///< Object ids.
};

}  // namespace inkbench
