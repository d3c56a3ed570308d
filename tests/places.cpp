// SPDX-License-Identifier: MIT
#include "tests/places.h"

namespace inkbench {

std::string inkbench_program() {
  return INKBENCH_EXECUTABLE;
}

std::string source_folder() {
  return INKBENCH_SOURCE_DIR;
}

std::string golden_output_folder() {
  return INKBENCH_GOLDEN_OUTPUT;
}

}  // namespace inkbench
