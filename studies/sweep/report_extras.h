// SPDX-License-Identifier: MIT
// What a report says beside a study's own cells, where something else than a study made them: a search.
#pragma once

#include <string>
#include <vector>

#include "studies/report/page.h"
#include "studies/sweep/study_charts.h"

namespace inkbench {

struct ReportExtras {
  std::string kind = "study";  ///< As `StudyPage::kind`.
  std::string command;         ///< That makes it all again; the study's own where empty.
  std::string verdict;
  std::vector<PageTable> tables;
  std::vector<DrawnChart> charts;  ///< Before the study's own.
  std::vector<PageLink> links;
};

}  // namespace inkbench
