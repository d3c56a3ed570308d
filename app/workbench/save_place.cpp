// SPDX-License-Identifier: MIT
#include "app/workbench/save_place.h"

#include <algorithm>

#include "app/workbench/folder_listing.h"

namespace inkbench {

namespace fs = std::filesystem;

fs::path save_path(std::string_view typed, const fs::path& folder,
                   std::span<const std::string_view> endings) {
  fs::path path = path_from_text(typed, folder);
  std::error_code error;
  if (!path.has_filename() || fs::is_directory(path, error) || endings.empty()) return path;
  const std::string given = path.extension().string();
  if (std::find(endings.begin(), endings.end(), given) == endings.end()) path += endings.front();
  return path;
}

std::string save_problem(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return path.string() + " is a folder; add a name";
  const fs::path folder = path.parent_path();
  if (fs::is_directory(folder, error)) return "";
  return (fs::exists(folder, error) ? "This is no folder: " : "There is no folder ") + folder.string();
}

bool is_taken(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

}  // namespace inkbench
