// SPDX-License-Identifier: MIT
// The marks of a search's pictures, each with the drawing that it is about: the one that its file keeps, or
// what the scene's own values draw. In: a spec. Out: marks ready to count.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/pipeline.h"
#include "studies/tuning/tune_spec.h"

namespace inkbench {

class PictureMarks {
 public:
  struct Entry {
    MarkMaps marks;
    CountedMarks counted;
    Key key;  ///< Of all that decides what is counted.
  };

  /// Draws nothing yet. Both must outlive it.
  PictureMarks(Pipeline& pipeline, const TuneSpec& spec)
      : pipeline_(pipeline), spec_(spec), entries_(spec.pictures.size()) {}

  /// Null for a picture without marks. Errors: as `Frame::raw`, where the scene must be drawn.
  const Entry* find(size_t picture);

 private:
  Pipeline& pipeline_;
  const TuneSpec& spec_;
  std::vector<std::optional<Entry>> entries_;
};

}  // namespace inkbench
