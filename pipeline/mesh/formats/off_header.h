// SPDX-License-Identifier: MIT
// The header of an OFF file: what its keyword promises of each vertex, and the counts. In: a cursor at the
// file's start. Out: the header; the cursor stands behind it.
#pragma once

#include <cstdint>

#include "pipeline/mesh/formats/text_cursor.h"

namespace inkbench {

struct OffHeader {
  bool has_normals = false;
  bool has_colours = false;
  bool has_texture_places = false;
  uint64_t vertices = 0;
  uint64_t faces = 0;

  /// Coordinates and normal, which stand first.
  int needed_numbers() const { return has_normals ? 6 : 3; }
  /// With what follows them: a colour of four numbers and a texture place of two.
  int all_numbers() const { return needed_numbers() + (has_colours ? 4 : 0) + (has_texture_places ? 2 : 0); }
};

/// [ST][C][N][4][n]OFF in any case, or nothing; then the dimension after an n; then the counts of vertices,
/// faces and, where it is there, edges. They may follow the keyword without a blank. Errors (input): another
/// format; points of other than three dimensions; the binary kind; counts missing.
OffHeader read_off_header(TextCursor& cursor);

}  // namespace inkbench
