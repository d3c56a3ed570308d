// SPDX-License-Identifier: MIT
// What the explanations of several detectors have in common.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/passes/edges/edge_class.h"
#include "pipeline/passes/edges/explanation.h"
#include "pipeline/passes/edges/operators.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// By object id - 1.
std::vector<std::string> model_names(const Settings& settings);

/// Of a detector whose largest term decides, each with its own limit: sum, verdict and, where `strength`
/// reaches 1, the class. `weak`: the share of the limit from which a pixel goes on with a line.
Explanation explained_by_largest(std::string_view detector, std::vector<ExplainedTerm> terms, double strength,
                                 double weak, EdgeClass edge_class);

}  // namespace inkbench
