// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/locked_file.h"
#include "pipeline/base/system_reason.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr std::string_view kTemporaryMark = ".part";
constexpr size_t kRandomDigits = 16;

/// "grid.png.part0123456789abcdef", or "grid.png.part812-3" of an older inkbench.
bool is_temporary_name(const std::string& name) {
  const size_t mark = name.rfind(kTemporaryMark);
  if (mark == std::string::npos) return false;
  const std::string rest = name.substr(mark + kTemporaryMark.size());
  if (rest.size() == kRandomDigits) return is_hex(rest, kRandomDigits);
  unsigned process = 0, count = 0;
  int length = 0;
  return std::sscanf(rest.c_str(), "%u-%u%n", &process, &count, &length) == 2 &&
         length == static_cast<int>(rest.size());
}

void sync_descriptor(const Descriptor& file, const fs::path& path) {
  // Some file systems have no such thing, and say so.
  if (fsync(file.number()) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS) return;
  throw work_error(path.string(), "writing stopped", system_reason(errno));
}

}  // namespace

void append_to_file(const fs::path& path, std::string_view text) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC);
  const ssize_t written = descriptor < 0 ? -1 : write(descriptor, text.data(), text.size());
  const int number = errno;
  if (descriptor >= 0) close(descriptor);
  if (written == static_cast<ssize_t>(text.size())) return;
  throw work_error(path.string(),
                   "a row could not be added: " + std::string(std::strerror(written < 0 ? number : ENOSPC)));
}

void sync_path(const fs::path& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) throw work_error(path.string(), "cannot be opened", system_reason(errno));
  sync_descriptor(file, path);
}

PendingFile::PendingFile(const fs::path& path, Sync sync) : path_(path), sync_(sync) {
  temporary_ = path;
  temporary_ += std::string(kTemporaryMark) + random_digits();
  file_ = make_locked_file(temporary_, 0666);
  if (!file_.is_open()) throw work_error(path.string(), "cannot be written", system_reason(errno));
  removal_.emplace([name = temporary_.string()] { unlink(name.c_str()); });
}

PendingFile::~PendingFile() {
  if (!committed_) unlink(temporary_.c_str());
}

void PendingFile::append(std::span<const uint8_t> data) {
  while (!data.empty()) {
    const ssize_t written = write(file_.number(), data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw work_error(path_.string(), "writing stopped", system_reason(errno));
    data = data.subspan(static_cast<size_t>(written));
  }
}

void PendingFile::commit() {
  // Some file systems tell of a failed write only where a descriptor is closed; this one's lock must stay.
  const int twin = dup(file_.number());
  if (twin >= 0 && close(twin) != 0)
    throw work_error(path_.string(), "writing stopped", system_reason(errno));
  if (sync_ == Sync::now) {
    sync_descriptor(file_, path_);
  } else {
    sync_file_range(file_.number(), 0, 0, SYNC_FILE_RANGE_WRITE);  // begins; `sync_path` waits
  }
  if (rename(temporary_.c_str(), path_.c_str()) != 0) {
    throw work_error(path_.string(), "cannot be written", system_reason(errno));
  }
  committed_ = true;
  file_.reset();
  if (sync_ == Sync::now) sync_path(path_.has_parent_path() ? path_.parent_path() : fs::path("."));
}

void write_file_atomically(const fs::path& path, const std::function<void(const FileSink&)>& produce,
                           Sync sync) {
  if (path.has_parent_path()) make_folder(path.parent_path());
  PendingFile file(path, sync);
  produce([&](std::span<const uint8_t> data) { file.append(data); });
  file.commit();
}

void write_file_atomically(const fs::path& path, std::string_view content, Sync sync) {
  write_file_atomically(
      path,
      [&](const FileSink& sink) {
        sink({reinterpret_cast<const uint8_t*>(content.data()), content.size()});
      },
      sync);
}

void remove_abandoned_files(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> abandoned;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (is_temporary_name(entry->path().filename().string())) abandoned.push_back(entry->path());
  }
  for (const fs::path& path : abandoned) {
    if (const Descriptor held = take_abandoned(path); held.is_open()) fs::remove(path, error);
  }
}

}  // namespace inkbench
