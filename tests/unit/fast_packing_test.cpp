// SPDX-License-Identifier: MIT
// Packing for speed: what comes back, and that the same bytes are always packed the same.
#include "pipeline/image/fast_packing.h"

#include <gtest/gtest.h>

#include <random>

namespace inkbench {
namespace {

/// Bytes that repeat here and there, as rows of pictures do.
std::vector<uint8_t> picture_like(size_t size, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<uint8_t> bytes(size);
  for (size_t i = 0; i < size; ++i)
    bytes[i] = i >= 48 && random() % 8 != 0 ? bytes[i - 48] : static_cast<uint8_t>(random() % 5);
  return bytes;
}

TEST(FastPacking, unpacks_to_the_same_bytes_across_blocks) {
  for (const size_t size :
       {size_t{0}, size_t{1}, size_t{65'535}, size_t{65'536}, size_t{65'537}, size_t{300'000}}) {
    const std::vector<uint8_t> bytes = picture_like(size, 1);
    EXPECT_EQ(unpacked(fast_packed(bytes), size), bytes) << size;
  }
}

TEST(FastPacking, does_not_depend_on_what_lies_behind_the_bytes) {
  for (uint32_t seed = 0; seed < 60; ++seed) {
    const size_t size = 500 + 37 * seed;
    std::vector<uint8_t> a = picture_like(size, seed), b = a;
    for (size_t i = 0; i < 200; ++i) {
      a.push_back(a[i]);
      b.push_back(static_cast<uint8_t>(i * 7));
    }
    EXPECT_EQ(fast_packed(std::span(a).first(size)), fast_packed(std::span(b).first(size))) << seed;
  }
}

}  // namespace
}  // namespace inkbench
