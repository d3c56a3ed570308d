// SPDX-License-Identifier: MIT
// A finished study's report page, index.html. In: the study's spec and folder, and what is kept of its
// pictures as the grid takes it. Out: the file, beside grid.png.
#pragma once

#include <exception>
#include <filesystem>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/worker_pool.h"
#include "studies/report/page.h"
#include "studies/report/thumbnail.h"
#include "studies/sweep/cell_tiles.h"
#include "studies/sweep/report_extras.h"
#include "studies/sweep/spec.h"
#include "studies/sweep/study_charts.h"
#include "studies/sweep/study_folder.h"

namespace inkbench {

/// How the study was run.
struct StudyOrigin {
  std::string command;
  std::string renderer;
  std::vector<std::pair<std::string, std::string>> versions;
  ReportExtras extras;
};

class StudyPageWriter {
 public:
  /// All cells must have ended.
  StudyPageWriter(const StudySpec& spec, const StudyFolder& folder, const StudyOrigin& origin,
                  const std::vector<DrawnChart>& charts, CellTiles& tiles);

  /// Takes a picture's thumbnail; where its page is fuller or emptier than was foreseen, makes it of the
  /// picture on another thread. Each picture is given once, from one thread.
  void add(size_t cell, size_t shown, const KeptPicture& kept);

  /// Writes index.html; returns its path. Errors (work): full disk, a thumbnail could not be made.
  std::filesystem::path write(const std::vector<std::filesystem::path>& grids);

 private:
  void make_thumbnail(size_t cell, size_t shown);

  std::filesystem::path folder_;
  CellTiles& tiles_;
  StudyPage page_;
  ThumbnailPlan plan_;
  std::mutex mutex_;
  std::exception_ptr failure_;
  WorkerPool workers_;  // last: it ends before what its threads use
};

}  // namespace inkbench
