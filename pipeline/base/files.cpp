// SPDX-License-Identifier: MIT
#include "pipeline/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <vector>

#include "pipeline/base/error.h"

/// Where the package lies that a program was linked with. Only programs outside the tree have it: the package
/// compiles scripts/package/prefix.cpp into them.
extern "C" [[gnu::weak]] const char* inkbench_package_prefix();

namespace inkbench {
namespace {

std::string reason(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "the disk is full; free some space or choose another folder";
    case EFBIG:
      return "the file would exceed the allowed file size; raise the limit or choose a smaller image";
    case EACCES:
    case EPERM:
      return "permission denied; choose a folder you may write to";
    case EROFS:
      return "the file system is read-only; choose another folder";
    default:
      return std::strerror(error_number);
  }
}

constexpr std::string_view kTemporaryMark = ".part";

/// Whether the name is a temporary one ("grid.png.part812-3") whose writer, by its process id, no longer
/// runs. Our own id counts as that of an earlier process: in a container every run may have the same.
bool is_abandoned(const std::string& name) {
  const size_t mark = name.rfind(kTemporaryMark);
  if (mark == std::string::npos) return false;
  int process = 0;
  int count = 0;
  int length = 0;
  const std::string rest = name.substr(mark + kTemporaryMark.size());
  const bool fits = std::sscanf(rest.c_str(), "%d-%d%n", &process, &count, &length) == 2 &&
                    length == static_cast<int>(rest.size());
  if (!fits || process <= 0) return false;
  return process == getpid() || (kill(process, 0) != 0 && errno == ESRCH);
}

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

std::string read_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw input_error(path.string(), "no such file");
  if (fs::is_directory(status)) throw input_error(path.string(), "is a folder", "a file is needed");
  if (fs::is_character_file(status) || fs::is_block_file(status)) {
    throw input_error(path.string(), "is a device", "a file is needed");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw input_error(path.string(), "cannot be opened", reason(errno));
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad()) throw work_error(path.string(), "reading stopped", reason(errno));
  return std::move(content).str();
}

PendingFile::PendingFile(const fs::path& path) : path_(path) {
  static std::atomic<unsigned> counter = 0;
  temporary_ = path;
  temporary_ += std::string(kTemporaryMark) + std::to_string(getpid()) + "-" + std::to_string(counter++);
  descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw work_error(path.string(), "cannot be written", reason(errno));
}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!committed_) unlink(temporary_.c_str());
}

void PendingFile::append(std::span<const uint8_t> data) {
  while (!data.empty()) {
    const ssize_t written = write(descriptor_, data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw work_error(path_.string(), "writing stopped", reason(errno));
    data = data.subspan(static_cast<size_t>(written));
  }
}

void PendingFile::commit() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0) throw work_error(path_.string(), "writing stopped", reason(errno));
  if (rename(temporary_.c_str(), path_.c_str()) != 0) {
    throw work_error(path_.string(), "cannot be written", reason(errno));
  }
  committed_ = true;
}

void write_file_atomically(const fs::path& path, const std::function<void(const FileSink&)>& produce) {
  if (path.has_parent_path()) make_folder(path.parent_path());
  PendingFile file(path);
  produce([&](std::span<const uint8_t> data) { file.append(data); });
  file.commit();
}

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_file_atomically(path, [&](const FileSink& sink) {
    sink({reinterpret_cast<const uint8_t*>(content.data()), content.size()});
  });
}

void remove_abandoned_files(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> abandoned;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (is_abandoned(entry->path().filename().string())) abandoned.push_back(entry->path());
  }
  for (const fs::path& path : abandoned) fs::remove(path, error);
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  const int number = error ? error.value() : ENOTDIR;
  if (fs::is_directory(path, error)) return;
  throw work_error(path.string(), "this folder cannot be made", reason(number));
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
