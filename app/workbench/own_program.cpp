// SPDX-License-Identifier: MIT
#include "app/workbench/own_program.h"

namespace inkbench {

std::filesystem::path own_program() {
  const std::filesystem::path link = "/proc/self/exe";
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink(link, error);
  return error ? link : program;
}

}  // namespace inkbench
