// SPDX-License-Identifier: MIT
// A study's spec that moves to another folder.
#pragma once

#include <filesystem>
#include <string>

namespace inkbench {

/// The spec's text as it means the same in any folder: paths relative to `folder` made absolute where they
/// stand, the rest as it is. Text that is no TOML stays: reading it says what is wrong.
std::string with_whole_paths(const std::string& text, const std::filesystem::path& folder);

}  // namespace inkbench
