// SPDX-License-Identifier: MIT
// Ramps of their own: as a TOML file of stops, or as an image.
#pragma once

#include <filesystem>

#include "pipeline/params/toml_document.h"
#include "pipeline/settings/ramp.h"

namespace inkbench {

/// By the name's ending: `.toml` holds the stops exactly; `.png` (8 bits a colour) and `.exr` (exact) hold
/// `kRampTexels` columns. Errors (input): another ending, an image ramp that cannot be read; (work): the file
/// cannot be written.
void save_ramp(const std::filesystem::path& path, const Ramp& ramp);

/// A TOML file's stops, or an image as a ramp that reads it. Errors (input): file:line of what is wrong in a
/// TOML file; not an image.
Ramp load_ramp(const std::filesystem::path& path);

/// Whether a document holds a ramp: `stops = [...]`, which no scene, preset or study has.
bool is_ramp_document(const TomlNode& document);
/// The ramp in such a document. Errors (input): `name:line`.
Ramp parse_ramp(const TomlNode& document, const std::string& name);

}  // namespace inkbench
