// Levels of meshes without waiting for them. In: the settings, once a frame. Out: the settings that can be
// drawn now; while a ladder is made beside the window, those show the full mesh.
#pragma once

#include <atomic>
#include <optional>

#include "app/workbench/ladder_maker.h"
#include "pipeline/passes/gbuffer/gpu_mesh.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

class LadderDesk {
 public:
  LadderDesk();
  Settings drawable(MeshStore& meshes, const Settings& settings);
  /// Whether a ladder is being made.
  bool is_busy() const { return maker_.is_busy(); }
  /// Whether one was made since the last call.
  bool take_news() { return news_.exchange(false); }

 private:
  std::optional<LadderRequest> request_for(MeshStore& meshes, const Settings& settings) const;

  std::atomic<bool> news_ = false;
  std::optional<LadderName> asked_, failed_;
  LadderMaker maker_;
};

}  // namespace inkbench
