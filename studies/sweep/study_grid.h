// SPDX-License-Identifier: MIT
// A finished study's cells as its grid, and where each picture stands in it.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "studies/report/grid.h"
#include "studies/report/grid_tile.h"
#include "studies/sweep/kept_picture.h"
#include "studies/sweep/spec.h"
#include "studies/sweep/study_folder.h"

namespace inkbench {

/// The labels of the columns (`index` 0), rows or pages; one empty text where there are none.
GridAxis grid_axis(const StudySpec& spec, size_t index);

/// Along a camera path the columns are its frames, every second, third, ... where there are many, the first
/// axis makes rows and all others together pages. Whether the grid shows this one of a cell's pictures,
/// counted by view and buffer.
bool is_in_grid(const StudySpec& spec, size_t shown);

/// The frames of the path that the grid shows, in order; all of a spec's views without a path.
std::vector<size_t> views_in_grid(const StudySpec& spec);

/// What people call a view: its name, or how far the camera is turned ("10°").
std::string view_label(const StudySpec& spec, size_t view);

/// A cell of the grid: its pictures side by side, or where one cell is the whole study, one of them.
struct CellLayout {
  bool one_picture = false;         ///< A cell of the grid is one picture, at its own size.
  size_t pictures = 1;              ///< In a cell of the grid; the study's cell may be several of them.
  int picture_width_px = 0;         ///< As the spec says it; one of another size is cut or stands on white.
  int width_px = 0, height_px = 0;  ///< As it is.
  int room_width_px = 0, room_height_px = 0;  ///< Of a cell on the sheet.
};

/// Errors (work): the grid's font is missing.
CellLayout cell_layout(const StudySpec& spec);

/// Of a cell's picture, counted by view and buffer.
TilePlace place_of(const CellLayout& layout, size_t shown, const Picture& picture);

/// All that decides `place_of` besides the picture, for a key.
std::string text_of(const CellLayout& layout, size_t shown);

/// Gives what is kept of a finished cell's picture.
using TileSource = std::function<KeptPicture(size_t cell, size_t shown)>;

/// Writes grid.png and its further pages. Each picture is asked for once, in the grid's order.
std::vector<std::filesystem::path> write_study_grid(const StudySpec& spec, const StudyFolder& folder,
                                                    const TileSource& tile);

}  // namespace inkbench
