// SPDX-License-Identifier: MIT
// The columns of data.csv that tell cells apart, and what charts must know of every column. In: a spec. Out:
// names, labels, and the table as far as it is known before a cell is drawn.
#pragma once

#include <string>
#include <vector>

#include "studies/report/chart.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// Keys that cells set, in order of first use.
std::vector<std::string> varied_keys(const StudySpec& spec);

/// A parameter's value as a field of data.csv: as TOML, but texts without quotes, and files relative to the
/// spec's folder where the way there does not lead through the root.
std::string field_text(const StudySpec& spec, const ConstParam& param);

/// `cell`, `variant`, the varied keys and the numbers, with what a chart says of them.
std::vector<ChartColumn> chart_columns(const StudySpec& spec);

/// data.csv with all of `chart_columns`, the measured ones empty.
CsvTable planned_table(const StudySpec& spec);

}  // namespace inkbench
