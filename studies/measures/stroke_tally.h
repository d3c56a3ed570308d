// SPDX-License-Identifier: MIT
// How steady strokes are between the frames of a camera path. In: what became of one frame's strokes in the
// next. Out: the paint's median shift, and the share of strokes that break.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace inkbench {

/// Pools by addition. Places: points of strokes that lie at the same place of a mesh in both frames
/// (`Curve::places`).
struct StrokeTally {
  std::vector<float> shifts_px;  ///< By how much the paint moved along the line, at each place; signed.
  int64_t strokes = 0;           ///< Of the earlier frames, those that have places.
  int64_t broken = 0;            ///< Of those, whose places go on in no stroke, or in several.

  void add(const StrokeTally& other);
  /// Median of the shifts' sizes; none without shifts.
  std::optional<double> median_shift_px() const;
  /// broken / strokes; none without strokes.
  std::optional<double> broken_share() const;
};

}  // namespace inkbench
