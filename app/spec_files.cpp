// SPDX-License-Identifier: MIT
#include "app/spec_files.h"

#include <algorithm>

namespace inkbench {

std::vector<std::filesystem::path> specs_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> specs;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") specs.push_back(entry.path());
  }
  std::sort(specs.begin(), specs.end());
  return specs;
}

}  // namespace inkbench
