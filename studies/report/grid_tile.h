// SPDX-License-Identifier: MIT
// What the grid shows of one picture of a cell, made while the picture is in memory. A cell may hold several
// pictures side by side and is scaled as a whole, so that a column of the drawn cell may be a mean over two
// of them: their columns there are kept as they are. In: pictures, one after the other. Out: the drawn cell.
#pragma once

#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

/// Where a picture stands in its cell, and at what size the cell is drawn.
struct TilePlace {
  int cell_width_px = 0, cell_height_px = 0;    ///< All its pictures side by side, as they are.
  int drawn_width_px = 0, drawn_height_px = 0;  ///< The cell on the sheet.
  int first_px = 0,
      end_px = 0;  ///< The cell's columns up to the next picture, or to its end; more than none.
  bool operator==(const TilePlace&) const = default;
};

struct Tile {
  TilePlace place;
  int drawn_first_px = 0;  ///< The column of the drawn cell where `drawn` begins.
  Picture drawn;           ///< The columns that this picture alone decides; may have none.
  Picture left, right;     ///< At full size: what neighbours need of its columns, from its ends inwards.
  bool operator==(const Tile&) const = default;
};

/// A picture (3 channels) larger than its place is cut, around a smaller one it is white.
Tile make_tile(const Picture& picture, const TilePlace& place);

/// The drawn cell, of the tiles of all its pictures in order: `scaled` of the cell as a whole.
Picture joined(std::vector<Tile> tiles);

}  // namespace inkbench
