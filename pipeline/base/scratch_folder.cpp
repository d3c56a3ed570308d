// SPDX-License-Identifier: MIT
#include "pipeline/base/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "pipeline/base/error.h"

namespace inkbench {

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
  std::string pattern = (place / "inkbench_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw work_error(pattern, "cannot be made", std::strerror(errno));
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

}  // namespace inkbench
