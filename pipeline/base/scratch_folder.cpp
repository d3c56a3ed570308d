// SPDX-License-Identifier: MIT
#include "pipeline/base/scratch_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/locked_file.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr std::string_view kStart = "inkbench_";
constexpr std::string_view kLockEnding = ".lock";
constexpr size_t kRandomChars = 16;

/// "inkbench_0123456789abcdef.lock". The folder cannot be the lock: a study locks the one that it writes to.
bool is_lock_name(const std::string& name) {
  const auto stem = without_ending(name, kLockEnding);
  return stem && stem->starts_with(kStart) && is_hex(stem->substr(kStart.size()), kRandomChars);
}

fs::path lock_of(const fs::path& folder) {
  return folder.string() + std::string(kLockEnding);
}

void remove_with_lock(const fs::path& folder) {
  std::error_code error;
  fs::remove_all(folder, error);
  fs::remove(lock_of(folder), error);
}

/// Removes what killed runs left in the place: what its owner is, and nobody who lives holds.
void sweep(const fs::path& place) {
  std::error_code error;
  std::vector<fs::path> locks;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    if (is_lock_name(entry->path().filename().string())) locks.push_back(entry->path());
  }
  for (const fs::path& lock : locks) {
    const Descriptor held = take_abandoned(lock);
    fs::path folder = lock;
    if (held.is_open()) remove_with_lock(folder.replace_extension());
  }
}

}  // namespace

fs::path temporary_place() {
  std::error_code error;
  fs::path place = fs::temp_directory_path(error);
  if (error) throw work_error("TMPDIR", "there is no folder for temporary files", error.message());
  return place;
}

fs::path memory_place() {
  const fs::path memory = "/dev/shm";
  std::error_code error;
  return fs::is_directory(memory, error) ? memory : temporary_place();
}

ScratchFolder::ScratchFolder(const fs::path& place) {
  sweep(place);
  const std::string name = std::string(kStart) + random_digits();
  const auto cannot = [&](int number) {
    return work_error((place / name).string(), "cannot be made", std::strerror(number));
  };
  lock_ = make_locked_file(lock_of(place / name), 0600);
  if (!lock_.is_open()) throw cannot(errno);
  if (mkdir((place / name).c_str(), 0700) != 0) {
    const int number = errno;
    unlink(lock_of(place / name).c_str());
    throw cannot(number);
  }
  path_ = place / name;
  removal_.emplace([path = path_] { remove_with_lock(path); });
}

ScratchFolder::~ScratchFolder() {
  remove_with_lock(path_);
}

}  // namespace inkbench
