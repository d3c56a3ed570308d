// SPDX-License-Identifier: MIT
// An imported scene as flat bytes, to cross the pipe from a reading child process.
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/mesh/formats/imported_scene.h"
#include "pipeline/mesh/formats/isolated_call.h"

namespace inkbench {

void send_scene(const ImportedScene& scene, const ByteSink& sink);

/// The scene back; its soups are consistent in their sizes. Errors (work): bytes that no `send_scene` wrote.
ImportedScene receive_scene(std::span<const uint8_t> bytes);

}  // namespace inkbench
