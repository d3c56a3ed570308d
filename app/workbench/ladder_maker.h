// SPDX-License-Identifier: MIT
// Makes a model's ladder beside the window: reading, subdividing and recording the collapses take seconds for
// large meshes. In: a model and the level that is wanted. Out: a ladder that gives that level at once.
#pragma once

#include <optional>

#include "app/workbench/background_work.h"
#include "pipeline/base/key.h"
#include "pipeline/mesh/levels/mesh_ladder.h"

namespace inkbench {

struct LadderName {
  Key key;  ///< `MeshStore::ladder_identity`
  bool has_record = false;
  bool operator==(const LadderName&) const = default;
};

struct LadderRequest {
  LadderName name;
  ModelParams model;
  MeshParams level;
};

struct MadeLadder {
  LadderName name;
  std::optional<MeshLadder> ladder;  ///< None where the mesh cannot be read.
};

class LadderMaker : public BackgroundWork<LadderRequest, MadeLadder, LadderName> {
 public:
  explicit LadderMaker(News& news);
};

}  // namespace inkbench
