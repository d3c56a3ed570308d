// SPDX-License-Identifier: MIT
// The progress of a study or a search: for people on stderr, one line that renews itself on a terminal, a
// quiet line now and then elsewhere; for programs on stdout, a JSON object a line.
#pragma once

#include <string>

#include "studies/sweep/run_study.h"

namespace inkbench {

enum class ProgressFormat { text, json };

/// How far it is, for people and for programs, so many seconds after it began.
struct ProgressNote {
  double seconds = 0;
  std::string text, json;
};
ProgressNote note_of(const StudyProgress& progress);

class ProgressLine {
 public:
  explicit ProgressLine(ProgressFormat format);
  /// Tells programs how much there is to do; people are told by the plan's line.
  void begin(const ProgressNote& note);
  void show(const ProgressNote& note);
  void finish(const ProgressNote& note);

 private:
  ProgressFormat format_;
  bool terminal_;
  double next_seconds_;
  bool open_ = false;
};

/// "12 / 49 cells, 14.2 a second, 3 s left".
std::string progress_text(const StudyProgress& progress);

/// {"done":12,"total":49,"drawn":12,"failed":0,"seconds":0.845}
std::string progress_json(const StudyProgress& progress);

}  // namespace inkbench
