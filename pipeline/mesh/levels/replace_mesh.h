// SPDX-License-Identifier: MIT
// Another mesh in the place of a scene's main model: what `--mesh` and a dropped file do.
#pragma once

#include <filesystem>

#include "pipeline/settings/settings.h"

namespace inkbench {

/// Puts the mesh where the main model stands, scaled to the same longest side and resting on the same place.
/// Errors (input): the scene has no model; the old mesh cannot be read where its size is needed.
void replace_main_mesh(Settings& settings, const std::filesystem::path& mesh);

}  // namespace inkbench
