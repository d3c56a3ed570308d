// SPDX-License-Identifier: MIT
// Levels of meshes without waiting for them. In: the settings, once a frame. Out: the settings that can be
// drawn now; while a ladder is made beside the window, those show the full mesh.
#pragma once

#include <optional>

#include "app/workbench/ladder_maker.h"
#include "pipeline/passes/gbuffer/gpu_mesh.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

class LadderDesk {
 public:
  explicit LadderDesk(News& news) : maker_(news) {}
  Settings drawable(MeshStore& meshes, const Settings& settings);
  /// Whether a ladder is being made.
  bool is_busy() const { return maker_.is_busy(); }

 private:
  std::optional<LadderRequest> request_for(MeshStore& meshes, const Settings& settings) const;

  std::optional<LadderName> failed_;
  LadderMaker maker_;
};

}  // namespace inkbench
