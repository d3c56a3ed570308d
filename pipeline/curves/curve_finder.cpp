// SPDX-License-Identifier: MIT
#include "pipeline/curves/curve_finder.h"

#include <glm/matrix.hpp>
#include <set>

namespace inkbench {
namespace {

Key key_with(const Key& key, const glm::mat4& matrix) {
  return KeyBuilder().add(key).add_bytes({reinterpret_cast<const uint8_t*>(&matrix), sizeof matrix}).key();
}

}  // namespace

std::vector<CurveFinder::Placed> CurveFinder::make_sources(const CurveRequest& request) {
  std::vector<Placed> placed;
  std::set<Key> used;
  for (const CurveRequestModel& model : request.models) {
    // Angles are those of the mesh as it is stretched; turning and moving it changes none.
    const glm::dmat3 linear(model.to_world);
    const glm::mat4 stretch(glm::mat3(glm::transpose(linear) * linear));
    const Key key =
        key_with(KeyBuilder().add(model.mesh_key).add(source_text(request.params)).key(), stretch);
    if (!sources_.contains(key))
      sources_.emplace(key, std::make_unique<CurveSource>(*model.mesh, request.params, linear));
    used.insert(key);
    placed.push_back({key, key_with(key, model.to_world)});
  }
  std::erase_if(sources_, [&](const auto& entry) { return !used.contains(entry.first); });
  return placed;
}

std::vector<ModelCuts> CurveFinder::make_cuts(const CurveRequest& request,
                                              const std::vector<Placed>& placed) {
  std::vector<ModelCuts> cuts;
  std::set<Key> used;
  if (request.params.intersection) {
    for (size_t i = 0; i < placed.size(); ++i) {
      const CurveSource& first = *sources_.at(placed[i].key);
      cuts.push_back({static_cast<int>(i), static_cast<int>(i), &first.own_cuts()});
      for (size_t j = i + 1; j < placed.size(); ++j) {
        const Key key = KeyBuilder().add(placed[i].placed_key).add(placed[j].placed_key).key();
        if (!cuts_.contains(key)) {
          const glm::dmat4 second_to_first =
              glm::inverse(glm::dmat4(request.models[i].to_world)) * glm::dmat4(request.models[j].to_world);
          cuts_.emplace(key,
                        cut_surfaces(first.to_cut(), sources_.at(placed[j].key)->to_cut(), second_to_first));
        }
        used.insert(key);
        cuts.push_back({static_cast<int>(i), static_cast<int>(j), &cuts_.at(key)});
      }
    }
  }
  std::erase_if(cuts_, [&](const auto& entry) { return !used.contains(entry.first); });
  return cuts;
}

Curves CurveFinder::find(const CurveRequest& request) {
  const std::lock_guard lock(mutex_);
  const std::vector<Placed> placed = make_sources(request);
  std::vector<CurveModel> models;
  for (size_t i = 0; i < placed.size(); ++i) {
    const glm::dmat4 to_world(request.models[i].to_world);
    models.push_back(
        {sources_.at(placed[i].key).get(), to_world, glm::inverse(to_world), request.models[i].object_id});
  }
  const std::vector<ModelCuts> cuts = make_cuts(request, placed);
  return object_curves(models, cuts, request.camera, request.width_px, request.height_px, request.params);
}

}  // namespace inkbench
