// A finished study's cells as its grid.
#pragma once

#include <filesystem>
#include <vector>

#include "studies/report/grid.h"
#include "studies/sweep/spec.h"
#include "studies/sweep/study_folder.h"

namespace inkbench {

/// The labels of the columns (`index` 0), rows or pages; one empty text where there are none.
GridAxis grid_axis(const StudySpec& spec, size_t index);

/// Reads the cells back from the disk a row at a time and writes grid.png and its further pages.
std::vector<std::filesystem::path> write_study_grid(const StudySpec& spec, const StudyFolder& folder);

}  // namespace inkbench
