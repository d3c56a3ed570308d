// SPDX-License-Identifier: MIT
#include "pipeline/base/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <initializer_list>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/system_reason.h"

/// Where the package lies that a program was linked with. Only programs outside the tree have it: the package
/// compiles scripts/package/prefix.cpp into them.
extern "C" [[gnu::weak]] const char* inkbench_package_prefix();

namespace inkbench {
namespace {

/// Empty where the system does not say.
fs::path executable_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// Where bin/, lib/ and share/ may lie. The first follows a program that was moved with them.
std::vector<fs::path> prefixes_in_use() {
  std::vector<fs::path> prefixes;
  if (const fs::path folder = executable_folder(); !folder.empty()) prefixes.push_back(folder.parent_path());
  if (inkbench_package_prefix != nullptr) prefixes.emplace_back(inkbench_package_prefix());
  return prefixes;
}

std::vector<fs::path> project_roots() {
  std::vector<fs::path> roots;
  if (const char* root = std::getenv("INKBENCH_ROOT"); root != nullptr && *root != '\0')
    roots.emplace_back(root);
  for (const fs::path& prefix : prefixes_in_use()) roots.push_back(prefix / INKBENCH_DATA_FOLDER);
  roots.emplace_back(INKBENCH_SOURCE_DIR);
  roots.push_back(fs::path(INKBENCH_PREFIX) / INKBENCH_DATA_FOLDER);
  return roots;
}

std::vector<fs::path> module_folders() {
  std::vector<fs::path> folders;
  if (const fs::path beside = executable_folder(); !beside.empty()) folders = {beside, beside.parent_path()};
  for (const fs::path& prefix : prefixes_in_use()) folders.push_back(prefix / INKBENCH_MODULE_FOLDER);
  folders.push_back(fs::path(INKBENCH_PREFIX) / INKBENCH_MODULE_FOLDER);
  return folders;
}

/// The first that holds all the entries; empty where none does.
fs::path first_with(const std::vector<fs::path>& folders, std::initializer_list<std::string_view> entries) {
  std::error_code error;
  const auto holds_all = [&](const fs::path& folder) {
    return std::all_of(entries.begin(), entries.end(),
                       [&](std::string_view entry) { return fs::exists(folder / entry, error); });
  };
  const auto found = std::find_if(folders.begin(), folders.end(), holds_all);
  return found == folders.end() ? fs::path() : *found;
}

std::string looked_in(const std::vector<fs::path>& folders) {
  std::string text;
  for (const fs::path& folder : folders) text += (text.empty() ? "" : ", ") + folder.string();
  return text;
}

}  // namespace

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  const int number = error ? error.value() : ENOTDIR;
  if (fs::is_directory(path, error)) return;
  throw work_error(path.string(), "this folder cannot be made", system_reason(number));
}

void make_inner_folder(const fs::path& path) {
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(path, error))) {
    throw work_error(path.string(), "is a link, and results are not written through one",
                     "remove it, or choose another folder");
  }
  make_folder(path);
}

fs::path project_root() {
  const std::vector<fs::path> roots = project_roots();
  if (fs::path root = first_with(roots, {"shaders", "data"}); !root.empty()) return root;
  throw work_error("", "the folders shaders/ and data/ were not found in: " + looked_in(roots),
                   "install inkbench again, or set INKBENCH_ROOT to the folder that holds them");
}

fs::path project_file(std::string_view relative) {
  return project_root() / relative;
}

fs::path module_file(std::string_view name) {
  const std::vector<fs::path> folders = module_folders();
  if (const fs::path folder = first_with(folders, {name}); !folder.empty()) return folder / name;
  throw work_error(std::string(name), "a part of inkbench, was not found in: " + looked_in(folders),
                   "build or install inkbench again, and keep this file beside the executable or "
                   "in " INKBENCH_MODULE_FOLDER);
}

}  // namespace inkbench
