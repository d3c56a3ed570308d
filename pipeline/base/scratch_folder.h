// SPDX-License-Identifier: MIT
// A folder for files that are needed for a while: it disappears with the object that made it.
#pragma once

#include <filesystem>
#include <optional>

#include "pipeline/base/descriptor.h"
#include "pipeline/base/forced_end.h"

namespace inkbench {

namespace fs = std::filesystem;

/// The system's folder for temporary files ($TMPDIR, else /tmp). Errors (work): there is none.
fs::path temporary_place();

/// A place in memory where the system has one, else `temporary_place`: for files written again and again.
fs::path memory_place();

/// A new, empty folder "inkbench_0123456789abcdef" inside `place`, open to its owner alone. It and whatever
/// lies in it then are removed at the end of the object's life; what cannot be removed stays, without an
/// error. What killed runs left in the place is removed first.
class ScratchFolder {
 public:
  /// Errors (work): the folder cannot be made, and why.
  explicit ScratchFolder(const fs::path& place = temporary_place());
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  Descriptor lock_;
  std::optional<ForcedEndAction> removal_;
};

}  // namespace inkbench
