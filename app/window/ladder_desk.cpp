// SPDX-License-Identifier: MIT
#include "app/window/ladder_desk.h"

#include "pipeline/base/error.h"

namespace inkbench {

/// Nothing where the settings can be drawn at once, or where trying to is the way to learn why not.
std::optional<LadderRequest> LadderDesk::request_for(MeshStore& meshes, const Settings& settings) const {
  const std::optional<size_t> index = main_model_index(settings);
  if (!index || !settings.models[*index].visible) return std::nullopt;
  const ModelParams& model = settings.models[*index];
  const MeshParams level = level_of(settings, *index);
  try {
    if (meshes.is_ready(model, level)) return std::nullopt;
    const LadderName name{meshes.ladder_identity(model, level.subdivide), level.faces > 0};
    if (failed_ == name) return std::nullopt;
    return LadderRequest{name, model, level};
  } catch (const Error&) {
    return std::nullopt;
  }
}

Settings LadderDesk::drawable(MeshStore& meshes, const Settings& settings) {
  if (std::optional<MadeLadder> made = maker_.take()) {
    if (maker_.has_asked(made->name)) maker_.forget();
    if (made->ladder) {
      meshes.take_ladder(made->name.key, std::move(*made->ladder));
    } else {
      failed_ = made->name;
    }
  }
  const std::optional<LadderRequest> request = request_for(meshes, settings);
  if (!request) return settings;
  maker_.ask(request->name, [&] { return *request; });
  Settings full = settings;
  full.mesh = {};
  return full;
}

}  // namespace inkbench
