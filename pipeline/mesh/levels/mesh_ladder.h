// SPDX-License-Identifier: MIT
// All levels of a model's mesh: the full mesh and, once a level is asked for, the record of its collapses.
// In: a model's shape or file. Out: the mesh of any level, in milliseconds. Meshes are shared, since they
// live in more than one place and may be large.
#pragma once

#include <memory>
#include <optional>

#include "pipeline/base/stop.h"
#include "pipeline/mesh/levels/collapse_record.h"
#include "pipeline/mesh/mesh.h"
#include "pipeline/settings/mesh_params.h"
#include "pipeline/settings/model.h"

namespace inkbench {

class MeshLadder {
 public:
  /// Reads or makes the mesh and subdivides it `rounds` times. Errors (input): as `make_model_mesh`.
  MeshLadder(const ModelParams& model, int rounds);

  int rounds() const { return rounds_; }
  const std::shared_ptr<const Mesh>& full() const { return full_; }

  /// Whether `level` gives a mesh at once; without, it first records the collapses: seconds for a large mesh.
  bool is_ready_for(const MeshParams& level) const;
  /// Makes it ready. Throws `Stopped`, which changes nothing, once `stop` says so.
  void prepare(const MeshParams& level, const StopAsked& stop = {});
  /// `level.subdivide` must be `rounds()`.
  std::shared_ptr<const Mesh> level(const MeshParams& level);

 private:
  bool decimates(const MeshParams& level) const;

  /// What `model` means for this model.
  LevelNormals normals_of(const MeshParams& level) const;

  int rounds_;
  ModelNormals model_normals_;
  std::shared_ptr<const Mesh> full_, subdivided_;
  std::optional<CollapseRecord> record_;  ///< Of `subdivided_`.
};

}  // namespace inkbench
