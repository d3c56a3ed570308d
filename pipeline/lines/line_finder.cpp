// SPDX-License-Identifier: MIT
#include "pipeline/lines/line_finder.h"

#include <set>

#include "pipeline/mesh/levels/model_mesh.h"

namespace inkbench {

LineFinder::Part LineFinder::part(const LineModel& model, const JudgeParams& judge) {
  if (!full_.contains(model.full_key)) {
    MeshTopology topology = make_topology(*model.full);
    FeatureParams params(judge);
    for (int axis = 0; axis < 3; ++axis) params.stretch[axis][axis] = model.params.scale[axis];
    full_.emplace(model.full_key, FullMesh{bounds_of(*model.full), make_features(topology, params)});
    if (model.drawn == model.full) drawn_.try_emplace(model.drawn_key, std::move(topology));
  }
  if (!drawn_.contains(model.drawn_key)) drawn_.emplace(model.drawn_key, make_topology(*model.drawn));
  return {&full_.at(model.full_key), &drawn_.at(model.drawn_key)};
}

void LineFinder::free_unused(const LineRequest& request) {
  std::set<Key> used;
  for (const LineModel& model : request.models) used.insert({model.full_key, model.drawn_key});
  std::erase_if(full_, [&](const auto& entry) { return !used.contains(entry.first); });
  std::erase_if(drawn_, [&](const auto& entry) { return !used.contains(entry.first); });
}

ReferenceLines LineFinder::find(const LineRequest& request, const StopAsked& stop) {
  const std::lock_guard lock(mutex_);
  free_unused(request);
  std::vector<SceneMesh> scene;
  for (const LineModel& model : request.models) {
    stop_if_asked(stop);
    const Part part = this->part(model, request.judge);
    scene.push_back(
        {part.drawn, model_matrix(model.params, part.full->bounds), model.object_id, &part.full->features});
  }
  stop_if_asked(stop);
  return reference_lines(scene, request.camera, request.depth, request.object_id);
}

}  // namespace inkbench
