// SPDX-License-Identifier: MIT
#include "app/workbench/open_outside.h"

#include "app/workbench/child_process.h"
#include "pipeline/base/error.h"

namespace inkbench {

void open_outside(const std::filesystem::path& path) {
  try {
    start_detached({"xdg-open", std::filesystem::absolute(path).string()});
  } catch (const Error&) {
    throw work_error(path.string(), "cannot be opened: there is no xdg-open",
                     "install the package xdg-utils, or open it by hand");
  }
}

}  // namespace inkbench
