// SPDX-License-Identifier: MIT
// A search's report page: what came out in a sentence, tables, charts of the box, and the pictures of the
// paper's values, the default and the tuned ones, made as a study of three cells. In: a spec and its result.
// Out: that study and what its report says besides.
#pragma once

#include "studies/sweep/report_extras.h"
#include "studies/tuning/tune_spec.h"

namespace inkbench {

/// What the search cost.
struct TuneCost {
  size_t measured = 0, known = 0;  ///< Drawings: measured in this run, known from before or from equal lines.
  double seconds = 0;
};

/// Of the paper's method with the paper's coefficients on the same pictures, by group.
struct PaperScores {
  Score all;
  std::vector<Score> groups;
};

/// The first line of the report. Where leave-one-out is not better than the default it says that nothing was
/// gained.
std::string verdict_of(const TuneSpec& spec, const TuneResult& result, const PaperScores& paper);

/// Scores, what each parameter is worth, leave-one-out, cost.
std::vector<PageTable> tune_tables(const TuneSpec& spec, const TuneResult& result, const PaperScores& paper,
                                   const TuneCost& cost);

/// Of the tables that `tune_files` writes: the objective over the box, each number moved alone, the best so
/// far.
std::vector<Chart> tune_charts(const TuneSpec& spec, const TuneResult& result);

/// The settings of the paper's method with the paper's coefficients.
Settings papers_settings(const Settings& settings);

/// Paper, default and tuned as variants, the pictures as views.
StudySpec before_and_after(const TuneSpec& spec, const TuneResult& result);

}  // namespace inkbench
