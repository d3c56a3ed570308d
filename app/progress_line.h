// A study's progress on stderr: one line that renews itself on a terminal, a quiet line now and then
// elsewhere.
#pragma once

#include "studies/sweep/run_study.h"

namespace inkbench {

class ProgressLine {
 public:
  ProgressLine();
  void show(const StudyProgress& progress);
  void finish(const StudyProgress& progress);

 private:
  bool terminal_;
  double next_seconds_;
  bool open_ = false;
};

/// "12 / 49 cells, 14.2 a second, 3 s left".
std::string progress_text(const StudyProgress& progress);

}  // namespace inkbench
