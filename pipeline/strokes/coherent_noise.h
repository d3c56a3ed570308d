// SPDX-License-Identifier: MIT
// Randomness that is the same whenever it is asked for: hashes of numbers, and noise along a line.
#pragma once

#include <cstdint>

namespace inkbench {

/// A number that tells neither of both; all bits are as random as the others.
uint32_t hashed(uint32_t a, uint32_t b);

/// Smooth noise over a line, -1 to 1, which strays over a length of about 1; other seeds, other noise.
float coherent_noise(double at, uint32_t seed);

}  // namespace inkbench
