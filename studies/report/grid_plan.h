// SPDX-License-Identifier: MIT
// Where everything in the image grid goes: sizes, line breaks, labels, the split into pictures. Pure
// arithmetic on the layout and the widths of texts. In: a GridLayout. Out: sheets (one written picture each)
// for grid.cpp to draw.
#pragma once

#include <string>
#include <vector>

#include "studies/report/grid.h"
#include "studies/report/lettering.h"

namespace inkbench {

/// One line of text; its baseline starts at (x, y) on the sheet and runs to the right, or `upwards`.
struct GridLine {
  std::string text;
  TextStyle style;
  int x_px = 0;
  int y_px = 0;
  bool upwards = false;
};

/// A cell's place: the upper left pixel of its picture on the sheet.
struct GridSlot {
  int x_px = 0;
  int y_px = 0;
  int column = 0;
  int row = 0;
};

/// One written picture.
struct GridSheet {
  int width_px = 0;
  int height_px = 0;
  int page = 0;
  std::vector<GridLine> lines;
  std::vector<GridSlot> slots;  ///< Row by row from the top, from left to right.
};

struct GridPlan {
  int cell_width_px = 0;  ///< As drawn.
  int cell_height_px = 0;
  int frame_px = 1;  ///< Width of the line around each cell, outside its picture.
  int text_px = 14;  ///< Size of body text, for what is written inside cells.
  std::vector<GridSheet> sheets;
};

/// All sheets, in the order of `write_grid`. No text overlaps another or a cell, and nothing leaves its
/// sheet.
GridPlan plan_grid(const GridLayout& layout);

}  // namespace inkbench
