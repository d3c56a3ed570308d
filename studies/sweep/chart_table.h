// SPDX-License-Identifier: MIT
// One [[chart]] table of a study's spec. In: the table and what was read of the spec. Out: the chart, with
// all that the spec leaves out filled in from the descriptions of its columns.
#pragma once

#include "pipeline/params/toml_document.h"
#include "studies/report/chart.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// Errors (input): file:line for unknown or mistyped entries and for columns that data.csv will not have.
Chart read_chart(const TomlNode& table, const StudySpec& spec);

}  // namespace inkbench
