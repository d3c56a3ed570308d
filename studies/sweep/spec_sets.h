// SPDX-License-Identifier: MIT
// The [[variant]] and [[view]] tables of a study's spec: names and what they set. In: the spec's document and
// what was read of it so far. Out: sets whose every value the parameter accepts.
#pragma once

#include <string>
#include <vector>

#include "pipeline/params/toml_document.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// Errors (input): file:line for unknown or mistyped entries, names given twice, values that a parameter does
/// not accept, parameters that an axis varies, more axes than leave a side of the grid for variants.
std::vector<NamedSet> read_variants(const TomlNode& document, const StudySpec& spec);

/// The [[`kind`]] tables of any spec, by `path` and `base` of this one alone. Errors (input) as for views.
std::vector<NamedSet> read_sets(const TomlNode& document, const std::string& kind, const StudySpec& spec);

/// Errors (input): the same, parameters that a variant sets, names that cannot be part of a file's name.
std::vector<NamedSet> read_views(const TomlNode& document, const StudySpec& spec);

}  // namespace inkbench
