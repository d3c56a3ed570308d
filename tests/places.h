// SPDX-License-Identifier: MIT
// Where tests find the program, the sources, and room for what the golden tests draw. Only places.cpp is
// compiled with these paths, so that a compiler cache serves every clone.
#pragma once

#include <string>

namespace inkbench {

std::string inkbench_program();
std::string source_folder();
std::string golden_output_folder();

}  // namespace inkbench
