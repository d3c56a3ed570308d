// SPDX-License-Identifier: MIT
// What a search could do for a person's marks: which strokes are not as they were asked for, and which other
// method would do better. In: a spec with marks and the search's result. Out: what each of a few drawings
// makes of the strokes, in words, as a table and as JSON.
#pragma once

#include <string>
#include <vector>

#include "studies/report/page.h"
#include "studies/tuning/picture_marks.h"

namespace inkbench {

/// What becomes of one picture's strokes.
struct PictureStrokes {
  std::string picture;  ///< Its name; "" where the spec has no views and no groups.
  std::vector<MarkedStroke> strokes;
};

/// What a drawing of all marked pictures makes of the marks.
struct Compliance {
  std::string name;  ///< "tuned", "default", or the method's.
  MarkTally tally;
  std::vector<PictureStrokes> pictures;

  size_t strokes() const;
  size_t satisfied() const;
};

struct MarkReport {
  Compliance initial, tuned;
  std::vector<Compliance> methods;  ///< Others than the tuned one, each with the scene's own values.

  /// Those that satisfy more strokes than the tuned values, the best first.
  std::vector<const Compliance*> better() const;
};

/// Draws the default, the tuned values and, unless the search was stopped, every other method. Methods that
/// cannot draw the scene are left out.
MarkReport look_at_marks(Pipeline& pipeline, const TuneSpec& spec, const TuneResult& result);

/// A sentence for each picture with strokes that are not satisfied, or one that all are; then which methods
/// satisfy more.
std::vector<std::string> mark_sentences(const MarkReport& report);

/// A row for each drawing.
PageTable mark_table(const MarkReport& report);

}  // namespace inkbench
