// SPDX-License-Identifier: MIT
// Stroke styles: files of parameters that say how lines look, and nothing of what is seen. Bundled ones lie
// in data/styles/ and are called by their names. In: a name or a file. Out: its values, as a table that is
// read like any other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/params/toml_document.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// Of the bundled ones, in order.
std::vector<std::string> style_names();

/// What a style is for, in a line: the file's `title`. Errors (input): as `read_style`.
std::string style_title(const std::filesystem::path& file);

/// The file of a bundled style's name, or one by its path, relative to `folder`. Errors (input), with
/// `where`: there is none, with the nearest name.
std::filesystem::path find_style(const std::string& name, const std::filesystem::path& folder,
                                 const std::string& where);

/// The style's parameters. All of `stroke` and its classes are in it, those that the file does not mention
/// at their defaults, so that no other style shows through; of other groups what the file mentions. Errors
/// (input): file:line of what is wrong; a model, a light, the camera or the image, which are no style's.
TomlNode read_style(const std::filesystem::path& file);

/// Sets the style's parameters. Errors (input): as both.
void apply_style(Settings& settings, const std::string& name, const std::filesystem::path& folder,
                 const std::string& where);

/// The settings' style as a file that `read_style` reads.
std::string style_text(const std::string& title, const Settings& settings);

}  // namespace inkbench
