// SPDX-License-Identifier: MIT
// Loops whose turns do not depend on each other, on all processors.
#pragma once

#include <cstddef>
#include <functional>

namespace inkbench {

/// Calls `turn(0)` to `turn(count - 1)`, several at a time and in no order; returns when all have ended.
/// Throws what one of them threw. Few turns run on the caller's thread alone.
void for_each_in_parallel(size_t count, const std::function<void(size_t)>& turn);

}  // namespace inkbench
