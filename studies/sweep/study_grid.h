// A finished study's cells as its grid.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "pipeline/image/image.h"
#include "studies/report/grid.h"
#include "studies/sweep/spec.h"
#include "studies/sweep/study_folder.h"

namespace inkbench {

/// Told of each picture as it is read: the cell, which of its pictures, the picture.
using PictureSink = std::function<void(size_t cell, size_t picture, const Picture&)>;

/// The labels of the columns (`index` 0), rows or pages; one empty text where there are none.
GridAxis grid_axis(const StudySpec& spec, size_t index);

/// Reads the cells back from the disk a row at a time and writes grid.png and its further pages.
std::vector<std::filesystem::path> write_study_grid(const StudySpec& spec, const StudyFolder& folder,
                                                    const PictureSink& on_picture);

}  // namespace inkbench
