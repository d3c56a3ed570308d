// SPDX-License-Identifier: MIT
// The studies that were run from the window, newest first: what it lists, and continues or shows again. In
// and out: a small TOML file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace inkbench {

struct RecentStudy {
  std::string title;
  std::filesystem::path spec, folder;  ///< Absolute.
  bool operator==(const RecentStudy&) const = default;
};

inline constexpr size_t kMaxRecentStudies = 30;

/// Puts it at the front; one of the same folder gives way, and so does what is too much.
void add_recent_study(std::vector<RecentStudy>& studies, const RecentStudy& study);

/// Empty where there is no file. Errors (input): file and line of what is no such list.
std::vector<RecentStudy> load_recent_studies(const std::filesystem::path& file);

/// Errors (work): as `write_file_atomically`.
void save_recent_studies(const std::filesystem::path& file, const std::vector<RecentStudy>& studies);

/// Where studies go that a person did not place: inkbench/studies in $XDG_DATA_HOME, or in ~/.local/share.
/// Errors (work): as `user_folder`.
std::filesystem::path studies_folder();

}  // namespace inkbench
