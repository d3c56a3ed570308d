// The image grid of a study: cells with titles, axis labels and values, composed a row of cells at a time, so that
// memory does not grow with the number of cells. In: a layout and a way to get each cell. Out: grid.png and pages.
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
  std::string label;                ///< "k depth"; may be empty (variants have none).
  std::vector<std::string> values;  ///< One text for each column, row or page; at least one, which may be empty.
};

struct GridLayout {
  std::string title;
  std::string subtitle;             ///< One smaller line below it; may be empty.
  GridAxis columns, rows, pages;    ///< `rows` and `pages` with one empty value: no labels for them.
  int cell_width_px = 0;            ///< Size of a cell's picture before scaling.
  int cell_height_px = 0;
  int max_side_px = 16384;          ///< No written picture is longer than this.
  int min_cell_px = 160;            ///< Cells are scaled down to this longer side before columns and rows move to further pages.
};

/// The cell's picture (3 channels, the layout's cell size), or nothing where the cell failed (drawn hatched, with "failed").
using CellSource = std::function<std::optional<Picture>(int column, int row, int page)>;

/// Writes `folder/grid.png`, and where there are pages `folder/grid_2.png`, `folder/grid_3.png`, ... beside it. Returns their paths in order.
/// The same input gives the same bytes. Cells are asked for in order of page, row, column, each once.
std::vector<std::filesystem::path> write_grid(const std::filesystem::path& folder, const GridLayout& layout,
                                              const CellSource& cell, const ImageText& text);

}  // namespace inkbench
