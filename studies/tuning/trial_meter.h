// SPDX-License-Identifier: MIT
// Candidates of a search drawn and measured: a picture's candidates one after the other, measured beside the
// drawing. In: values. Out: what the pictures of each group add up to. Nothing is encoded, and what was drawn
// from the same inputs before is not drawn again.
#pragma once

#include <map>
#include <memory>

#include "pipeline/base/worker_pool.h"
#include "studies/judging/drawing_meter.h"
#include "studies/measures/tally.h"
#include "studies/sweep/result_origin.h"
#include "studies/tuning/picture_marks.h"
#include "studies/tuning/trial_journal.h"
#include "studies/tuning/tune_spec.h"

namespace inkbench {

class TrialMeter {
 public:
  /// All must outlive it. `journal`: a file for what is measured, or empty.
  TrialMeter(Pipeline& pipeline, const TuneSpec& spec, const std::filesystem::path& journal = {});

  /// As `MeasureCandidates`. A candidate that cannot be drawn has no tallies, and its error is kept.
  std::vector<GroupTallies> measure(const std::vector<Values>& candidates, const std::vector<bool>& wanted);

  /// Of one picture drawn with any settings; not kept. Errors: as `Frame::raw`.
  DrawingTally tally(size_t picture, const Settings& settings);

  /// Drawings so far: measured by this run, and known from an earlier one or from equal lines.
  size_t measured() const { return measured_; }
  size_t known() const { return known_; }
  /// What kept candidates from being drawn, each once.
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  /// What a picture's lines are measured against.
  struct Truth {
    Key key;
    std::shared_ptr<const ReferenceLines> lines;  ///< Null where no measure asks for them.
    const CountedMarks* marks = nullptr;
    LineView view;  ///< Without drawn lines.
    CountedReference counted;
  };
  /// One drawing on its way.
  using Pending = std::shared_ptr<DrawingTally>;

  std::shared_ptr<const Truth> truth(size_t picture, const Frame& frame);
  Pending start(size_t picture, const Frame& frame);
  DrawingTally tally(const LineMap& drawn, const Truth& truth, const JudgeParams& judge) const;
  Key key_of(size_t picture, const Frame& frame);
  bool needs_reference() const { return needs_f1_ || needs_.reference_lines(); }
  void keep_measured();

  Pipeline& pipeline_;
  const TuneSpec& spec_;
  std::vector<const Measure*> measures_;
  MeasureNeeds needs_;     ///< Of those beside F, precision and recall.
  bool needs_f1_ = false;  ///< One of those.
  DrawingMeter keys_;
  std::string origin_;
  TrialJournal journal_;
  PictureMarks marks_;
  std::vector<std::shared_ptr<const Truth>> truths_;  ///< By picture.
  std::map<Key, Pending> pending_;
  size_t measured_ = 0, known_ = 0;
  std::vector<std::string> problems_;
  WorkerPool workers_;  // last: it ends before what its threads use
};

}  // namespace inkbench
