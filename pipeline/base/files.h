// SPDX-License-Identifier: MIT
// Files read whole and written all or nothing, and where the project's own files (shaders, data, studies)
// lie.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/base/descriptor.h"
#include "pipeline/base/forced_end.h"

namespace inkbench {

namespace fs = std::filesystem;

/// The most that is read of one file of a kind, in bytes: scenes, specs and what else people write; images;
/// meshes; anything.
constexpr uintmax_t kMostTextBytes = uintmax_t{16} << 20;
constexpr uintmax_t kMostImageBytes = uintmax_t{1} << 30;
constexpr uintmax_t kMostMeshBytes = uintmax_t{2} << 30;
constexpr uintmax_t kMostFileBytes = uintmax_t{4} << 30;

/// The whole content, which is as long as the system says that the file is. Errors (input): missing; a
/// folder, device, pipe or a file of /proc; larger than `most_bytes`; changed meanwhile; not to be opened.
/// Errors (work): the system stopped reading it.
std::string read_file(const fs::path& path, uintmax_t most_bytes = kMostFileBytes);

/// What a file that may grow meanwhile holds from `offset` on, at most `most_bytes`. Errors as `read_file`.
std::string read_file_part(const fs::path& path, uintmax_t offset, uintmax_t most_bytes = kMostFileBytes);

/// Whether a written file is on the disk, power cut or not, before it takes its name; else soon after, and
/// `sync_path` waits for it.
enum class Sync { now, later };

/// Writes beside `path` under a temporary name and renames at the end, so that `path` holds either its old
/// content or all of the new one. Makes the parent folder. Errors (work): unwritable, full disk; the
/// temporary file is removed.
void write_file_atomically(const fs::path& path, std::string_view content, Sync sync = Sync::now);

/// The same for content written in pieces: `write(data)` is called through `sink`.
using FileSink = std::function<void(std::span<const uint8_t>)>;
void write_file_atomically(const fs::path& path, const std::function<void(const FileSink&)>& produce,
                           Sync sync = Sync::now);

/// Adds to the end of a file that is there. Errors (work): it cannot be written, full disk.
void append_to_file(const fs::path& path, std::string_view text);

/// Waits until a file's content, or a folder's names, are on the disk. Errors (work): they cannot be.
void sync_path(const fs::path& path);

/// A file under a temporary name beside `path`, which nobody can guess, that takes its name at `commit` and
/// otherwise disappears. For writers that outlive one call; `write_file_atomically` is simpler. All errors
/// are of kind work.
class PendingFile {
 public:
  explicit PendingFile(const fs::path& path, Sync sync = Sync::now);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  void append(std::span<const uint8_t> data);
  void commit();

 private:
  fs::path path_;
  fs::path temporary_;
  Sync sync_;
  Descriptor file_;  ///< Locked for as long as it is open, so that it is told from what a killed run left.
  bool committed_ = false;
  std::optional<ForcedEndAction> removal_;
};

/// Removes the temporary files in the folder (not below it) that writers left who were killed.
void remove_abandoned_files(const fs::path& folder);

/// Makes the folder and its parents. Errors (work): says why it cannot be made or written to.
void make_folder(const fs::path& path);

/// The same for a folder of ours within a folder of results, which must not be a link to elsewhere.
void make_inner_folder(const fs::path& path);

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
