// SPDX-License-Identifier: MIT
// What a person marked in a picture, and how far a drawing complies. In: the marks, the lines drawn when they
// were painted, the lines drawn now. Out: counts, which pool by addition, and what became of each stroke.
// Definitions: docs/measures.md.
#pragma once

#include <optional>
#include <vector>

#include "studies/measures/tally.h"

namespace inkbench {

/// How near a line must be to a wanted mark, and how near it may not be to what an unwanted mark covered.
inline constexpr double kWantedWithinPx = 3, kUnwantedWithinPx = 1;

/// One view's marks as they were painted; all maps have its size. No pixel is both.
struct MarkMaps {
  LineMap wanted;    ///< Here should be lines.
  LineMap unwanted;  ///< What is drawn here should go.
  LineMap drawn;     ///< The lines when the marks were painted, at least those under the marks.

  bool empty() const { return wanted.count() == 0 && unwanted.count() == 0; }
};

/// What of marks counts; both without the image's border.
struct CountedMarks {
  LineMap wanted;    ///< Thinned.
  LineMap unwanted;  ///< What was drawn under unwanted marks.
};
CountedMarks counted_marks(const MarkMaps& marks);

struct MarkTally {
  ShareCounts wanted;    ///< Found, of the wanted pixels.
  ShareCounts unwanted;  ///< Gone, of what was drawn under unwanted marks.

  void add(const MarkTally& other);
  /// 0 to 1: the harmonic mean of both shares; with one kind alone, its share; none without either.
  std::optional<double> value() const;
};

/// Of one view. Sizes must be the same.
MarkTally tally_marks(const CountedMarks& marks, const LineMap& drawn);

/// A connected stroke.
struct MarkedStroke {
  bool is_wanted = true;
  Pixel centre;        ///< Of the box around it.
  ShareCounts counts;  ///< As in the tally.

  /// Most of it is as it was asked for. An unwanted stroke under which nothing was drawn is.
  bool is_satisfied() const { return 2 * counts.matched >= counts.total; }
};

/// Every stroke, the wanted ones first, each kind in order of their first pixels. Sizes must be the same.
std::vector<MarkedStroke> look_at_strokes(const MarkMaps& marks, const LineMap& drawn);

}  // namespace inkbench
