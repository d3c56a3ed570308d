// SPDX-License-Identifier: MIT
// How much a study will do: for the line that the command line prints and the window shows before it runs.
#pragma once

#include <string>

#include "studies/sweep/spec.h"

namespace inkbench {

/// Pixels of all pictures of all cells.
double pixel_count(const StudySpec& spec);

/// What those pictures take on the disk at most.
double most_bytes(const StudySpec& spec);

/// "49 cells (7 x 7) of 1024 x 1024 px".
std::string shape_text(const StudySpec& spec);

/// The same, with what it will take: ", at most 154 MB".
std::string plan_text(const StudySpec& spec);

}  // namespace inkbench
