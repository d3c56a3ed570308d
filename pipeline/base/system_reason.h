// SPDX-License-Identifier: MIT
// Why the system refused, for people. In: an errno. Out: the reason and, where there is one, what to do.
#pragma once

#include <string>

namespace inkbench {

/// Of writing: "the disk is full; free some space or choose another folder".
std::string system_reason(int error_number);

}  // namespace inkbench
