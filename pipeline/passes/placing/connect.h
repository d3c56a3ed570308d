// SPDX-License-Identifier: MIT
// What depends on how pixels connect to lines: hysteresis, shortest length, taper towards the ends.
#pragma once

#include "pipeline/flow/flow.h"
#include "pipeline/gl/texture.h"
#include "pipeline/image/image.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// What is asked of connected lines.
struct ConnectParams {
  bool has_weak = false;    ///< Lines must reach strength 1 somewhere.
  float min_length_px = 0;  ///< Steps along it, diagonal ones sqrt(2); 0: all lines stay.
  float taper_px = 0;       ///< From an end on the width grows over this length.
};

/// Placed lines (placed_lines.h), packed, H x W x 4, without those that are too weak or too short, and with
/// the share of the width in place of the strength. A line's length is the longest way through its pixels
/// that a walk from end to end finds.
Image connected(Image placed, const ConnectParams& params);

class ConnectPass {
 public:
  using Value = Texture;
  static const PassKind& kind();
  /// Where nothing is asked for the placed lines are handed on.
  static bool hands_on(const Settings& settings);
  static const Texture& handed(const Texture& placed) { return placed; }
  static PassInput handed_by() { return {EdgesParams::description().group}; }
  Texture run(const Texture& placed, const ConnectParams& params) const;
};

}  // namespace inkbench
