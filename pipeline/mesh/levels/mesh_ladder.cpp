// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/mesh_ladder.h"

#include "pipeline/mesh/levels/collapse_record_file.h"
#include "pipeline/mesh/levels/level_normals.h"
#include "pipeline/mesh/levels/model_mesh.h"
#include "pipeline/mesh/levels/subdivide.h"

namespace inkbench {

MeshLadder::MeshLadder(const ModelParams& model, int rounds)
    : rounds_(rounds),
      model_normals_(model.normals),
      full_(std::make_shared<Mesh>(make_model_mesh(model))),
      subdivided_(rounds == 0 ? full_ : std::make_shared<Mesh>(subdivide_mesh(*full_, rounds))) {}

bool MeshLadder::decimates(const MeshParams& level) const {
  return level.faces > 0 && static_cast<size_t>(level.faces) < subdivided_->triangles.size();
}

LevelNormals MeshLadder::normals_of(const MeshParams& level) const {
  const bool is_flat = level.normals == LevelNormals::model && model_normals_ == ModelNormals::flat;
  return is_flat ? LevelNormals::flat : level.normals;
}

bool MeshLadder::is_ready_for(const MeshParams& level) const {
  return record_.has_value() || !decimates(level);
}

void MeshLadder::prepare(const MeshParams& level, const StopAsked& stop) {
  if (!is_ready_for(level)) record_ = cached_collapse_record(*subdivided_, stop);
}

std::shared_ptr<const Mesh> MeshLadder::level(const MeshParams& level) {
  if (decimates(level)) {
    prepare(level);
    return std::make_shared<Mesh>(
        level_with_normals(*subdivided_, *record_, static_cast<size_t>(level.faces), normals_of(level)));
  }
  // As loaded, smooth leaves the normals that a file may give.
  const LevelNormals normals = normals_of(level);
  if (normals == LevelNormals::smooth || normals == LevelNormals::model) return subdivided_;
  auto whole = std::make_shared<Mesh>(*subdivided_);
  apply_level_normals(*whole, normals, *full_);
  return whole;
}

}  // namespace inkbench
