// SPDX-License-Identifier: MIT
// Seconds as people say them.
#pragma once

#include <string>

namespace inkbench {

/// "7 s", "2 min 5 s", "1 h 30 min"; whole seconds, rounded up.
std::string duration_text(double seconds);

}  // namespace inkbench
