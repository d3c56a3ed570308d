// SPDX-License-Identifier: MIT
// Placed lines, whoever placed them: rgba32f, H x W. Red and green: from the pixel's centre to the line, in
// pixels, x to the right and y up, less than half each way, so that the point is the pixel's own; blue: the
// class (EdgeClass), 0 where no line goes through the pixel; alpha: the strength, or where that is under 1
// the share of the width that is drawn (connect.h). Neighbours of eight are one line, but for diagonal ones
// that have a line pixel beside both.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/texture.h"

namespace inkbench {

struct PlacedLines {
  using Value = Texture;
  static const PassKind& kind();
  /// By `edges.method`: `dihedral` places its lines itself.
  static size_t chosen(const Settings& settings);
};

}  // namespace inkbench
