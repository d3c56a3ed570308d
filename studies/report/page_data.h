// SPDX-License-Identifier: MIT
// What the report page's script reads: axes, cells, table. In: a StudyPage. Out: JSON that can stand inside
// <script>.
#pragma once

#include <string>

#include "studies/report/page.h"

namespace inkbench {

/// An object with the entries that studies/report/page/data.js names. Paths are URLs. What repeats from cell
/// to cell (folders and ends of file names, overlays) stands there once.
std::string page_data(const StudyPage& page);

}  // namespace inkbench
