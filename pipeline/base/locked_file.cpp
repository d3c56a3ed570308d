// SPDX-License-Identifier: MIT
#include "pipeline/base/locked_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

/// Some file systems have no locks: nothing is swept there.
bool is_locked_by_other(const Descriptor& file) {
  return flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

std::string random_digits() {
  uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number)
    throw work_error("", "the system gives no random numbers", std::strerror(errno));
  return fmt::format("{:016x}", number);
}

Descriptor make_locked_file(const std::filesystem::path& path, mode_t mode) {
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    Descriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
    if (!file.is_open()) return file;
    // A sweeper may have been there between the two calls.
    struct stat status {};
    if (!is_locked_by_other(file) && fstat(file.number(), &status) == 0 && status.st_nlink > 0) return file;
  }
  errno = EAGAIN;
  return {};
}

Descriptor take_abandoned(const std::filesystem::path& path) {
  Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat status {};
  const bool is_ours = file.is_open() && fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) &&
                       status.st_uid == geteuid();
  return is_ours && flock(file.number(), LOCK_EX | LOCK_NB) == 0 ? std::move(file) : Descriptor();
}

}  // namespace inkbench
