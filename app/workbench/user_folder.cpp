// SPDX-License-Identifier: MIT
#include "app/workbench/user_folder.h"

#include <cstdlib>

#include "pipeline/base/error.h"

namespace inkbench {
std::filesystem::path absolute_variable(const char* name) {
  const char* value = std::getenv(name);
  const std::filesystem::path path = value == nullptr ? "" : value;
  return path.is_absolute() ? path : std::filesystem::path();
}

std::filesystem::path user_folder() {
  if (const auto config = absolute_variable("XDG_CONFIG_HOME"); !config.empty()) return config / "inkbench";
  if (const auto home = absolute_variable("HOME"); !home.empty()) return home / ".config" / "inkbench";
  throw work_error("HOME", "is not set, so there is no place for presets and sessions",
                   "set HOME or XDG_CONFIG_HOME to a folder");
}

}  // namespace inkbench
