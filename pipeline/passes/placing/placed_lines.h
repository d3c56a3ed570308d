// SPDX-License-Identifier: MIT
// Placed lines, whoever placed them: rgba8, H x W, packed as shaders/lib/placed.glsl says. The offset from
// the pixel's centre to the line, in pixels, x to the right and y up, less than half each way, so that the
// point is the pixel's own; the class (EdgeClass), 0 where no line goes through the pixel; where it is under
// 1 the strength, of connected lines (connect.h) the share of the width that is drawn. Neighbours of eight
// are one line, but for diagonal ones that have a line pixel beside both.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/texture.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// One pixel's, unpacked.
struct PlacedLine {
  float offset_x = 0, offset_y = 0;
  EdgeClass line_class = EdgeClass::none;
  float share = 1;

  bool operator==(const PlacedLine&) const = default;
};

/// Of what `Texture::read(0, 4)` gives, and the other way round for `Texture::upload`.
PlacedLine placed_at(const Image& packed, int x, int y);
/// Of what `Texture::read_picture` gives, which is quicker and lacks the share: 1.
PlacedLine placed_at(const Picture& packed, int x, int y);
void set_placed(Image& packed, int x, int y, const PlacedLine& line);

struct PlacedLines {
  using Value = Texture;
  static const PassKind& kind();
  /// By `edges.method`: `dihedral` places its lines itself.
  static size_t chosen(const Settings& settings);
};

}  // namespace inkbench
