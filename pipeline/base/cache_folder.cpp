// SPDX-License-Identifier: MIT
#include "pipeline/base/cache_folder.h"

#include <cstdlib>

namespace inkbench {

std::filesystem::path cache_folder() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::filesystem::path(value == nullptr ? "" : value);
  };
  if (std::getenv("INKBENCH_CACHE") != nullptr) return variable("INKBENCH_CACHE");
  // A relative XDG_CACHE_HOME is to be ignored (XDG Base Directory Specification).
  if (const std::filesystem::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute())
    return cache / "inkbench";
  if (const std::filesystem::path home = variable("HOME"); !home.empty()) return home / ".cache" / "inkbench";
  return {};
}

}  // namespace inkbench
