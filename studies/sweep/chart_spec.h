// SPDX-License-Identifier: MIT
// The [[chart]] tables of a study's spec: which columns of data.csv to plot, and how. In: the spec's document
// and what was read of it so far. Out: charts that this study's cells can fill.
#pragma once

#include <vector>

#include "pipeline/params/toml_document.h"
#include "studies/report/chart.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// Errors (input): file:line for unknown or mistyped entries, columns that data.csv will not have, filters
/// that no cell passes, cells that would stand at the same place, two charts of one name.
std::vector<Chart> read_charts(const TomlNode& document, const StudySpec& spec);

}  // namespace inkbench
