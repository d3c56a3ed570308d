// SPDX-License-Identifier: MIT
// Every pass, in the order of the chain: the one list of them.
#pragma once

#include <vector>

#include "pipeline/flow/flow.h"

namespace inkbench {

/// Each stands after those whose values it takes.
std::vector<const PassKind*> all_passes();

/// Adds a pass of a program's own (or a test's) to the end of the list, with the parameter group that it
/// brings. Before the first settings are read and the first pipeline is made; a second time changes nothing.
void add_pass(const PassKind& kind);

}  // namespace inkbench
