// SPDX-License-Identifier: MIT
// Models that the far plane hides as a whole: an empty picture that says nothing would look like a fault of
// the mesh. In: camera and what is drawn. Out: a note in the log when a model goes beyond the far plane.
#pragma once

#include <set>
#include <span>

#include "pipeline/passes/gbuffer/draw_item.h"
#include "pipeline/settings/camera.h"

namespace inkbench {

/// The item's box lies behind the far plane as a whole, or, in whatever direction, farther from the eye than
/// any place before that plane that a picture of up to 2:1 can show: a model in units of its own, far away.
bool is_beyond_far(const DrawItem& item, const CameraParams& camera);

class BeyondFarNotes {
 public:
  /// One note for each model that is beyond the far plane and was not the time before.
  void update(std::span<const DrawItem> items, const CameraParams& camera);

 private:
  std::set<int> beyond_;  ///< Object ids.
};

}  // namespace inkbench
