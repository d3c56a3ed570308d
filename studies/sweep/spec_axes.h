// SPDX-License-Identifier: MIT
// The [[axis]] tables of a study's spec: which parameters vary, over which values. In: the spec's document
// and what was read of it so far. Out: axes whose every value the parameter accepts.
#pragma once

#include <vector>

#include "pipeline/params/toml_reader.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// Errors (input): file:line for unknown or mistyped entries, unknown keys, values that a parameter does not
/// accept, two axes over one parameter, more than three.
std::vector<Axis> read_axes(const TomlNode& document, const StudySpec& spec);

/// The table's `scale`, linear or log; `usual` where it has none. Errors (input): any other word.
Scale scale_entry(const TomlReader& toml, const TomlNode& table, Scale usual);

}  // namespace inkbench
