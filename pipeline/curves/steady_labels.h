// SPDX-License-Identifier: MIT
// What a line is of, without flicker along it. In: a label for each of its pixels. Out: labels that change
// only where they change for good.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace inkbench {

/// The labels, one for each pixel, that differ from the given ones at the fewest pixels, a change from one to
/// the next counted as `kChangePx` pixels: so a run of up to twice as many is absorbed, at an end of up to as
/// many. `ring`: the last pixel goes on into the first.
inline constexpr int kChangePx = 3;
std::vector<uint32_t> steady_labels(std::span<const uint32_t> labels, bool ring);

}  // namespace inkbench
