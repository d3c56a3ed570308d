// SPDX-License-Identifier: MIT
// Runs a study: draws its cells so that the cheapest change is innermost, encodes them beside the drawing,
// and leaves a folder with index.html, grid.png, cells/, data.csv and manifest.json. Continues what an
// earlier run of the same study left.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/pipeline.h"
#include "studies/sweep/report_extras.h"
#include "studies/sweep/result_origin.h"
#include "studies/sweep/spec.h"
#include "studies/sweep/study_charts.h"

namespace inkbench {

struct StudyProgress {
  size_t done = 0;  ///< Cells that are finished, those of earlier runs included.
  size_t total = 0;
  size_t drawn = 0;     ///< Of them, in this run.
  size_t measured = 0;  ///< Of them, measured again in this run, without being drawn.
  size_t failed = 0;
  double seconds = 0;  ///< Since this run started.
};

struct StudyOptions {
  std::filesystem::path folder;
  bool fresh = false;                       ///< Forget what an earlier run finished.
  bool fail_fast = false;                   ///< Stop at the first cell that fails.
  const std::atomic<bool>* stop = nullptr;  ///< Set from elsewhere to stop after the current cell.
  std::function<void(const StudyProgress&)>
      on_progress;  ///< After each cell, from any thread, one at a time.
  /// What makes the results; this build and the current context without it.
  std::optional<ResultOrigin> origin;
  ReportExtras extras;
};

struct StudyResult {
  StudyProgress progress;
  bool stopped = false;               ///< Not all cells were tried.
  std::vector<std::string> failures;  ///< "cell NAME: message", "chart NAME: message".
  std::vector<std::filesystem::path> grids;
  size_t pictures_decoded = 0;  ///< For grid and page, for want of their tiles.
  std::vector<DrawnChart> charts;
  std::filesystem::path page;  ///< The report; empty where the study was stopped.
};

/// Errors (work): the folder cannot be written. A cell's own error is a failure in the result.
StudyResult run_study(Pipeline& pipeline, const StudySpec& spec, const StudyOptions& options);

/// One drawing of a study: a cell from one of the spec's views.
struct CellView {
  size_t cell = 0, view = 0;
  bool operator==(const CellView&) const = default;
};

/// The order in which cells are drawn: the axis (or the views) whose change costs most outermost.
std::vector<CellView> run_order(Pipeline& pipeline, const StudySpec& spec);

}  // namespace inkbench
