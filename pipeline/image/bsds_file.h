// SPDX-License-Identifier: MIT
// The ground truth of BSDS500 and of data sets in its form: a MATLAB file (version 5) whose variable
// `groundTruth` is a cell array with a structure for each annotator, whose field `Boundaries` is a matrix.
// In: such a file. Out: the matrices as pictures.
// Source: MathWorks, "MAT-File Format", 2019; Arbelaez et al., BSDS500.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

/// Whether the bytes begin as a MATLAB file does.
bool is_mat_file(std::string_view content);

/// One picture for each annotator, H x W x 1: 255 where `Boundaries` is not 0. At least one. Errors (input):
/// as `read_file`; no MATLAB file, or one of version 7.3; damaged; without `groundTruth` and `Boundaries`.
std::vector<Picture> read_bsds_boundaries(const std::filesystem::path& path);

}  // namespace inkbench
