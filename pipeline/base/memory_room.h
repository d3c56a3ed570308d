// SPDX-License-Identifier: MIT
// How much memory there is still to be had, so that what cannot fit is refused with the numbers instead of
// being ended by the system in the middle of its work.
#pragma once

#include <cstdint>
#include <string>

namespace inkbench {

/// Bytes: the least of what the system has available, with swap, what the control groups of this process and
/// its limits on address space leave. As much as can be where the system does not say.
uintmax_t memory_room();

/// Errors (work): `bytes` are more than there is room for: "`where`: `what` needs about 45 GB of memory, and
/// 12 GB can be had; `instead`".
void check_memory(double bytes, const std::string& where, const std::string& what,
                  const std::string& instead);

}  // namespace inkbench
