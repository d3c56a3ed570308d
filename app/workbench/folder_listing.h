// SPDX-License-Identifier: MIT
// What a folder holds, for choosing files; and paths as people type or paste them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

struct FolderEntry {
  std::string name;
  bool is_folder = false;
  std::uintmax_t bytes = 0;
};

struct FolderListing {
  std::filesystem::path folder;
  std::vector<FolderEntry> entries;  ///< Folders first, each kind in order of the alphabet.
  std::string problem;               ///< Why there are none, or not all.
};

/// More are not listed; the listing says so.
inline constexpr size_t kMaxListed = 2000;

/// Folders, and files whose names end in one of `extensions` (".png"; all without any). Hidden ones and names
/// that are not UTF-8 are left out. Throws nothing: what is wrong is the listing's problem.
FolderListing list_folder(const std::filesystem::path& folder, std::span<const std::string_view> extensions);

/// The absolute path that a text means: blanks and quotes around it are dropped, "~" is the home folder,
/// "file://" of a file manager is decoded, a relative one is taken from `folder`. Empty for an empty text.
std::filesystem::path path_from_text(std::string_view text, const std::filesystem::path& folder);

/// To show a path: the home folder as "~".
std::string path_text(const std::filesystem::path& path);

/// Of letters without regard to case.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace inkbench
