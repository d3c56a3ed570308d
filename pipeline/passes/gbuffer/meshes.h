// SPDX-License-Identifier: MIT
// Meshes: what the G-buffer draws, read, decimated and uploaded. In: the models' shapes and files, the main
// model's level. Out: a mesh on the GPU for each visible model.
#pragma once

#include <glm/mat4x4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/flow/inputs.h"
#include "pipeline/passes/gbuffer/draw_item.h"
#include "pipeline/passes/gbuffer/gpu_mesh.h"

namespace inkbench {

/// By the scene's order of models; null where the model is not visible.
using ModelMeshes = std::vector<std::shared_ptr<const GpuMesh>>;

/// A model and the level of it that is drawn.
struct MeshRequest {
  const ModelParams* model = nullptr;
  MeshParams level;
};

class MeshesPass {
 public:
  using Value = ModelMeshes;
  static const PassKind& kind();
  explicit MeshesPass(Flow& flow) : store_(flow.shared<MeshStore>()) {}
  /// Meshes that are not asked for leave the store. Errors (input): a mesh cannot be read.
  ModelMeshes run(const std::vector<MeshRequest>& requests) const;

 private:
  MeshStore& store_;
};

/// What the settings draw with these meshes: the visible models where they stand.
std::vector<DrawItem> draw_items(const Settings& settings, const ModelMeshes& meshes);

/// The models that the G-buffer draws. Run with: std::span<const DrawItem>.
struct DrawItems {
  std::shared_ptr<const ModelMeshes> meshes;  ///< Keeps them alive.
  std::vector<DrawItem> items;
};
struct BoundDrawItems {
  BoundValue<MeshesPass> meshes;
  void fold(KeyBuilder& key, const FrameState& frame) const;
  /// Errors (input): the settings contradict each other (`check_settings`).
  DrawItems get(const FrameState& frame) const;
};
struct DrawItemsInput {
  BoundDrawItems bind(Flow& flow) const { return {value_of<MeshesPass>().bind(flow)}; }
  static std::vector<PassInput> told();
};
inline std::span<const DrawItem> as_argument(const DrawItems& drawn) {
  return drawn.items;
}

}  // namespace inkbench
