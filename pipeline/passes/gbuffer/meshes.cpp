// SPDX-License-Identifier: MIT
#include "pipeline/passes/gbuffer/meshes.h"

#include "pipeline/flow/describe_pass.h"
#include "pipeline/mesh/levels/model_mesh.h"

namespace inkbench {
namespace {

/// The visible models; others have no request.
struct MeshRequestsInput {
  MeshStore* store = nullptr;

  MeshRequestsInput bind(Flow& flow) const { return {&flow.shared<MeshStore>()}; }
  static std::vector<PassInput> told() {
    return {{ModelParams::description().group}, {MeshParams::description().group}};
  }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    for (const MeshRequest& request : get(frame)) {
      if (request.model != nullptr) key.add(store->identity(*request.model, request.level));
      key.add(request.model != nullptr ? "visible" : "hidden");
    }
  }
  std::vector<MeshRequest> get(const FrameState& frame) const {
    const Settings& settings = frame.settings;
    std::vector<MeshRequest> requests(settings.models.size());
    for (size_t i = 0; i < requests.size(); ++i) {
      if (settings.models[i].visible) requests[i] = {&settings.models[i], level_of(settings, i)};
    }
    return requests;
  }
};

}  // namespace

const PassKind& MeshesPass::kind() {
  static const PassKind kKind = describe_pass<MeshesPass>("meshes", 200, {}, MeshRequestsInput{});
  return kKind;
}

ModelMeshes MeshesPass::run(const std::vector<MeshRequest>& requests) const {
  std::vector<Key> used;
  for (const MeshRequest& request : requests) {
    if (request.model != nullptr) used.push_back(store_.identity(*request.model, request.level));
  }
  store_.keep_only(used);
  ModelMeshes meshes;
  for (const MeshRequest& request : requests)
    meshes.push_back(request.model == nullptr ? nullptr : store_.get(*request.model, request.level));
  return meshes;
}

std::vector<DrawItem> draw_items(const Settings& settings, const ModelMeshes& meshes) {
  std::vector<DrawItem> items;
  for (size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i] == nullptr) continue;
    const ModelParams& model = settings.models[i];
    items.push_back({meshes[i].get(), model_matrix(model, meshes[i]->placement()), static_cast<int>(i) + 1,
                     model.two_sided, model.name});
  }
  return items;
}

std::vector<PassInput> DrawItemsInput::told() {
  std::vector<PassInput> told = decltype(value_of<MeshesPass>())::told();
  told.push_back({ModelParams::description().group});
  return told;
}

void BoundDrawItems::fold(KeyBuilder& key, const FrameState& frame) const {
  meshes.fold(key, frame);
  for (const ModelParams& model : frame.settings.models) key.add(group_text(model));
}

DrawItems BoundDrawItems::get(const FrameState& frame) const {
  check_settings(frame.settings);
  DrawItems drawn{meshes.get(frame), {}};
  drawn.items = draw_items(frame.settings, *drawn.meshes);
  return drawn;
}

}  // namespace inkbench
