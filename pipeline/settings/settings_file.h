// SPDX-License-Identifier: MIT
// Settings in TOML: scene files, the settings in an image's metadata and presets are one format.
// [[model]] and [[light]] are lists of named tables; every other parameter is `group.name = value`, but for
// `style`, which takes those of a stroke style (style_file.h).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "pipeline/params/toml_document.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// Reads a scene file; `base = "other.toml"` starts from that scene, whose models and lights the file may
/// change by name. Errors (input): file:line for unknown, duplicate, mistyped or out-of-range entries; files
/// that refer to each other in a circle; missing files.
Settings load_settings(const std::filesystem::path& path);

/// The same from text; `name` stands for the file in errors, relative paths are taken from `folder`.
Settings parse_settings(std::string_view text, const std::string& name, const std::filesystem::path& folder);

/// The same from a document that was read already.
Settings parse_settings(const TomlNode& document, const std::string& name,
                        const std::filesystem::path& folder);

/// Applies a table of parameters ("dotted keys or tables") to the settings. Errors (input) as
/// `load_settings`.
void apply_table(Settings& settings, const TomlNode& table, const std::string& name,
                 const std::filesystem::path& folder);

/// Calls `visit` for each value in a table of parameters, its key ("model.rabbit.size", "camera.eye.x") being
/// `prefix` and the table's keys; first for those of the style that the entry `style` names. Errors (input):
/// `name:line` of an unknown key, one that sets the same as an earlier one, an empty table that is no group.
using ParamVisitor = std::function<void(const Param& param, const TomlNode& node)>;
void visit_table(Settings& settings, const TomlNode& table, const std::string& prefix,
                 const std::string& name, const ParamVisitor& visit);

/// How the first line of a preset begins, a scene file of all settings; by it it is told from other scene
/// files.
inline constexpr std::string_view kPresetMark = "# inkbench preset";

/// All of the settings as TOML; reading it back gives equal settings.
std::string settings_text(const Settings& settings);

}  // namespace inkbench
