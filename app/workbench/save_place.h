// SPDX-License-Identifier: MIT
// Where a person wants to save: what every question for a file's name looks at before anything is written.
// In: the whole path. Out: why nothing can be saved there, or whether something would be replaced.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace inkbench {

/// What a typed name means in a folder: it may be a whole path. One without an ending of those that can be
/// written gets the first of them, a folder's stays as it is. Empty for an empty name.
std::filesystem::path save_path(std::string_view typed, const std::filesystem::path& folder,
                                std::span<const std::string_view> endings);

/// Why not, for the person; empty where it can be. The folder must be there: a mistyped one is not made.
std::string save_problem(const std::filesystem::path& path);

/// Whether there is something already, a link that leads nowhere included.
bool is_taken(const std::filesystem::path& path);

}  // namespace inkbench
