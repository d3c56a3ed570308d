// SPDX-License-Identifier: MIT
// A view's marks as an image file: red where a line is wanted, blue where what is drawn should go, darker of
// both where a line was drawn when they were painted. Anything else (white, grey, clear) is no mark, so that
// a person can paint them in any program, over nothing or over a drawing.
#pragma once

#include <filesystem>

#include "studies/measures/marks.h"

namespace inkbench {

struct MarkFile {
  MarkMaps marks;
  /// Whether the file has darker marks. Where it has none, as when it was painted by hand, `marks.drawn` is
  /// empty of lines, and what was drawn is for the reader to find.
  bool keeps_drawing = false;
};

/// Red and blue of a third of full strength at most in the other channels count, up to three quarters of it
/// as darker. Errors (input): as `read_picture`; a size that is not the view's; no mark in it.
MarkFile read_marks(const std::filesystem::path& path, int width_px, int height_px);

/// The drawing's other lines are in it, too, as black, for a person to paint beside. Errors (work): as
/// `write_png`.
void write_marks(const std::filesystem::path& path, const MarkMaps& marks);

}  // namespace inkbench
