// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include "pipeline/base/descriptor.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

/// What keeps this from being read as a file; nothing where it is one.
std::optional<Error> kind_problem(const fs::path& path, mode_t mode) {
  if (S_ISREG(mode)) return std::nullopt;
  if (S_ISDIR(mode)) return input_error(path.string(), "is a folder", "a file is needed");
  if (S_ISCHR(mode) || S_ISBLK(mode)) return input_error(path.string(), "is a device", "a file is needed");
  return input_error(path.string(), "is not a regular file", "a file is needed");
}

Error cannot_be_opened(const fs::path& path, int number) {
  if (number == ENOENT || number == ENOTDIR) return input_error(path.string(), "no such file");
  return input_error(path.string(), "cannot be opened", std::strerror(number));
}

Error not_as_large(const fs::path& path, size_t read_bytes, size_t file_bytes) {
  const auto text = [](size_t bytes) { return with_commas(static_cast<long long>(bytes)); };
  return input_error(path.string(),
                     "its size is " + text(file_bytes) + " bytes, but " +
                         (read_bytes > file_bytes ? "more" : text(read_bytes)) + " were read",
                     "it changed meanwhile, or is no file on a disk: copy it to one");
}

/// A file that is open for reading, looked at before (opening a device may do something) and after.
class OpenFile {
 public:
  explicit OpenFile(const fs::path& path) : path_(path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) throw cannot_be_opened(path, errno);
    if (const std::optional<Error> problem = kind_problem(path, status.st_mode)) throw Error(*problem);
    descriptor_ = Descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!descriptor_.is_open() || fstat(descriptor_.number(), &status) != 0)
      throw cannot_be_opened(path, errno);
    if (const std::optional<Error> problem = kind_problem(path, status.st_mode)) throw Error(*problem);
    bytes_ = static_cast<size_t>(status.st_size);
  }

  size_t bytes() const { return bytes_; }

  /// What lies from `offset` on, at most `most` bytes; fewer at the file's end alone. Errors (work): the
  /// system cannot read it.
  std::string read(size_t offset, size_t most) const {
    std::string content(most, '\0');
    size_t got = 0;
    while (got < most) {
      const ssize_t count =
          pread(descriptor_.number(), content.data() + got, most - got, static_cast<off_t>(offset + got));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) {
        throw work_error(path_.string(),
                         "reading stopped after " +
                             with_commas(static_cast<long long>(offset) + static_cast<long long>(got)) +
                             " of " + with_commas(static_cast<long long>(bytes_)) + " bytes",
                         std::strerror(errno));
      }
      if (count == 0) break;
      got += static_cast<size_t>(count);
    }
    content.resize(got);
    return content;
  }

 private:
  fs::path path_;
  Descriptor descriptor_;
  size_t bytes_ = 0;
};

}  // namespace

std::string read_file(const fs::path& path, uintmax_t most_bytes) {
  const OpenFile file(path);
  if (file.bytes() > most_bytes) {
    throw input_error(path.string(), "is too large: " + readable_bytes(static_cast<double>(file.bytes())),
                      "at most " + readable_bytes(static_cast<double>(most_bytes)) + " are read");
  }
  // A file of /proc says 0 bytes and holds more.
  std::string content = file.read(0, file.bytes());
  if (content.size() == file.bytes() && file.read(file.bytes(), 1).empty()) return content;
  const bool is_more = content.size() == file.bytes();
  throw not_as_large(path, content.size() + (is_more ? 1 : 0), file.bytes());
}

std::string read_file_part(const fs::path& path, uintmax_t offset, uintmax_t most_bytes) {
  const OpenFile file(path);
  const uintmax_t rest = file.bytes() - std::min<uintmax_t>(offset, file.bytes());
  return file.read(offset, std::min(rest, most_bytes));
}

}  // namespace inkbench
