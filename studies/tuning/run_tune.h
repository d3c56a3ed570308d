// SPDX-License-Identifier: MIT
// A whole search into a folder: the journal while it runs, then tuned.toml, trace.csv, box.csv, profiles.csv,
// tuning.json, charts and a report with pictures before and after. Continues what an earlier run of the same
// search measured.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/pipeline.h"
#include "studies/tuning/tune_report.h"

namespace inkbench {

struct TuneOptions {
  std::filesystem::path folder;
  bool fresh = false;  ///< Forget what an earlier run measured.
  bool report = true;  ///< Charts, pictures and the page; else data alone.
  TuneProgress on_progress;
  std::string command;  ///< That was given.
};

struct TuneOutcome {
  TuneResult result;
  TuneCost cost;
  std::string verdict;
  std::vector<std::string>
      marks;  ///< What of the marks could not be satisfied, a sentence each; empty without marks.
  std::filesystem::path preset, page;  ///< `page` is empty without a report.
  std::vector<std::string> problems;   ///< Why candidates, charts or pictures could not be made.
};

/// Errors (input): no candidate could be drawn; (work): the folder cannot be written.
TuneOutcome run_tune(Pipeline& pipeline, const TuneSpec& spec, const TuneOptions& options);

}  // namespace inkbench
