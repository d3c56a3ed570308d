// SPDX-License-Identifier: MIT
#include "pipeline/strokes/coherent_noise.h"

#include <cmath>

namespace inkbench {
namespace {

float lattice_value(int64_t at, uint32_t seed) {
  const uint32_t bits = hashed(hashed(seed, static_cast<uint32_t>(at)), static_cast<uint32_t>(at >> 32));
  return static_cast<float>(bits) / 2147483648.0F - 1.0F;
}

/// Between whole numbers by a polynomial whose first two derivatives are 0 at both.
float octave(double at, uint32_t seed) {
  const double low = std::floor(at);
  const auto place = static_cast<int64_t>(low);
  const auto t = static_cast<float>(at - low);
  const float share = t * t * t * (t * (6.0F * t - 15.0F) + 10.0F);
  const float from = lattice_value(place, seed), to = lattice_value(place + 1, seed);
  return from + share * (to - from);
}

}  // namespace

uint32_t hashed(uint32_t a, uint32_t b) {
  // The finaliser of MurmurHash3.
  uint32_t bits = a * 0x9e3779b9U ^ (b + 0x7f4a7c15U + (a << 6) + (a >> 2));
  bits ^= bits >> 16;
  bits *= 0x85ebca6bU;
  bits ^= bits >> 13;
  bits *= 0xc2b2ae35U;
  bits ^= bits >> 16;
  return bits;
}

float coherent_noise(double at, uint32_t seed) {
  return 0.7F * octave(at, seed) + 0.3F * octave(2.17 * at, hashed(seed, 1));
}

}  // namespace inkbench
