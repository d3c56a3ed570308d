// SPDX-License-Identifier: MIT
// Files read whole and written all or nothing, and where the project's own files (shaders, data, studies)
// lie.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace inkbench {

namespace fs = std::filesystem;

/// The whole content. Errors (input): missing, a folder, unreadable, each with what to do.
std::string read_file(const fs::path& path);

/// Writes beside `path` under a temporary name and renames at the end, so that `path` holds either its old
/// content or all of the new one. Makes the parent folder. Errors (work): unwritable, full disk; the
/// temporary file is removed.
void write_file_atomically(const fs::path& path, std::string_view content);

/// The same for content written in pieces: `write(data)` is called through `sink`.
using FileSink = std::function<void(std::span<const uint8_t>)>;
void write_file_atomically(const fs::path& path, const std::function<void(const FileSink&)>& produce);

/// A file under a temporary name beside `path` that takes its name at `commit` and otherwise disappears. For
/// writers that outlive one call; `write_file_atomically` is simpler. All errors are of kind work.
class PendingFile {
 public:
  explicit PendingFile(const fs::path& path);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  void append(std::span<const uint8_t> data);
  void commit();

 private:
  fs::path path_;
  fs::path temporary_;
  int descriptor_ = -1;
  bool committed_ = false;
};

/// Removes the temporary files in the folder (not below it) that writers left who were killed.
void remove_abandoned_files(const fs::path& folder);

/// Makes the folder and its parents. Errors (work): says why it cannot be made or written to.
void make_folder(const fs::path& path);

/// A file of the project itself, by its path in the source tree ("shaders/combine.frag"): looked for under
/// $INKBENCH_ROOT, then in ../share/inkbench from the executable, in that of the package that a program
/// outside the tree was linked with, in the source tree it was built from, and where it was to be installed.
/// Errors (work): where it was looked for.
fs::path project_file(std::string_view relative);

/// A library that is opened when it is first needed, by its file's name: looked for beside the executable, in
/// the folder above it (a build folder's tests), then in lib/inkbench of the same prefixes as
/// `project_file`. Errors (work): where it was looked for.
fs::path module_file(std::string_view name);

/// The first folder of `project_file`'s search that holds shaders/ and data/.
fs::path project_root();

}  // namespace inkbench
