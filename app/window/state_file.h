// SPDX-License-Identifier: MIT
// What the window is doing, as JSON, for tests and reports: settings, view, counts, problems, where widgets
// are.
#pragma once

#include <string>

#include "app/window/workbench.h"

namespace inkbench {

std::string state_text(const Workbench& bench);

}  // namespace inkbench
