// SPDX-License-Identifier: MIT
// The specs that lie in a folder, for commands that list or run all of them.
#pragma once

#include <filesystem>
#include <vector>

namespace inkbench {

/// Its .toml files, by name; not those of folders in it. Errors (filesystem_error): it cannot be read.
std::vector<std::filesystem::path> specs_in(const std::filesystem::path& folder);

}  // namespace inkbench
