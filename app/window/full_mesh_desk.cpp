// SPDX-License-Identifier: MIT
#include "app/window/full_mesh_desk.h"

namespace inkbench {

void FullMeshDesk::forget() {
  if (own_ && own_->reference.is_busy()) return;  // the end of its work would be waited for
  if (own_) own_->pipeline.forget_results();      // nothing of it stays in the pool
  own_.reset();
  edges_.forget();
  behind_ = false;
}

bool FullMeshDesk::refresh_lines(MeshStore& meshes, const Frame& full, bool hurry) {
  ReferenceDesk& reference = own_->reference;
  const bool is_other = reference.now() == nullptr || reference.now()->key != full.key(BufferName::reference);
  if (is_other && hurry) return false;
  // Only what is drawn next: meshes that nobody draws would pile up while a model's shape is dragged.
  for (const ModelParams& model : full.settings().models) {
    if (is_other && model.visible) own_->pipeline.meshes().share_full(meshes, model);
  }
  reference.refresh(full);
  return !reference.is_behind();
}

KeyedView FullMeshDesk::refresh(Pipeline& pipeline, const Frame& frame, bool hurry) {
  if (frame.settings().mesh == MeshParams{}) {
    forget();
    return {};
  }
  if (!own_) own_ = std::make_unique<Own>(pipeline.line_finder(), news_);
  Settings settings = frame.settings();
  settings.mesh = {};
  const Frame full = own_->pipeline.at(settings);
  behind_ = !refresh_lines(pipeline.meshes(), full, hurry);
  if (behind_) return {};
  const Key key = full.key(BufferName::lines);
  const auto& edges =
      edges_.get(key, [&] { return std::make_shared<const Image>(full.raw(BufferName::lines)); });
  return {{edges, own_->reference.now()->lines}, KeyBuilder().add(key).add(own_->reference.now()->key).key()};
}

}  // namespace inkbench
