// SPDX-License-Identifier: MIT
// The image grid of a study: cells with titles, axis labels and values, composed a row of cells at a time, so
// that memory does not grow with the number of cells. In: a layout and a way to get each cell. Out: grid.png
// and pages.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/image/image.h"
#include "pipeline/image/image_file.h"

namespace inkbench {

struct GridAxis {
  std::string label;  ///< "k depth"; may be empty (variants have none).
  std::vector<std::string>
      values;  ///< One text for each column, row or page; at least one, which may be empty.
};

struct GridLayout {
  std::string title;              ///< May be empty.
  std::string subtitle;           ///< One smaller line below it; may be empty.
  GridAxis columns, rows, pages;  ///< `rows` and `pages` with one empty value: no labels for them.
  int cell_width_px = 0;          ///< Size of a cell's picture before scaling, at least 1.
  int cell_height_px = 0;
  int max_side_px = 16384;  ///< No written picture is longer than this; at least 1024.
  int min_cell_px = 160;    ///< Cells shrink to this longer side before the rest moves to further pages.
};

/// The size that a picture has in a cell: as large as fits, its aspect kept.
struct DrawnSize {
  int width_px = 0, height_px = 0;
};
DrawnSize size_in_cell(int width_px, int height_px, int cell_width_px, int cell_height_px);

/// The cell's picture (3 channels, the layout's cell size or as it is drawn), or nothing where the cell
/// failed (drawn hatched, with "failed"). A picture of another size is fitted into the cell. Called on the
/// thread that called `write_grid`.
using CellSource = std::function<std::optional<Picture>(int column, int row, int page)>;

/// Writes `folder/grid.png`, and where one picture does not hold all, `folder/grid_2.png`,
/// `folder/grid_3.png`, ... beside it: first the parts of the first page, then those of the second. Returns
/// their paths in order. The same input gives the same bytes. Cells are asked for each once, in the order
/// they are drawn: by picture, row, column (which is page, row, column where no page is split). Cells that
/// need not shrink are copied exactly. An axis that stands alone (the other has one empty value) is laid out
/// as a near-square block with each value above its cell once it is longer than a strip of a few cells.
/// Errors (work): full disk, the font is missing (naming its package); what `cell` throws.
std::vector<std::filesystem::path> write_grid(const std::filesystem::path& folder, const GridLayout& layout,
                                              const CellSource& cell, const ImageText& text);

}  // namespace inkbench
