// SPDX-License-Identifier: MIT
// Definitions of docs/measures.md written down as plainly as can be, for small maps: what a fuzz target
// compares the measures with.
#pragma once

#include <cstdint>

#include "pipeline/lines/line_map.h"

namespace inkbench {

/// The size of a largest matching at a squared distance of at most `squared`.
int64_t plain_matched(const LineMap& a, const LineMap& b, int64_t squared);

/// The number of 8-connected parts.
int64_t plain_parts(LineMap map);

/// The pixels of `from` at a squared distance above `squared` from all of `to`.
LineMap plain_far(const LineMap& from, const LineMap& to, int64_t squared);

}  // namespace inkbench
