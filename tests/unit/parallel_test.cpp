// SPDX-License-Identifier: MIT
#include "pipeline/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace inkbench {
namespace {

TEST(ForEachInParallel, TakesEveryTurnOnceAlsoFromWithinAnother) {
  for (const size_t count : {size_t{0}, size_t{1}, size_t{17}, size_t{5000}}) {
    std::vector<std::atomic<int>> taken(count);
    for_each_in_parallel(count, [&](size_t i) { ++taken[i]; });
    for (size_t i = 0; i < count; ++i) ASSERT_EQ(taken[i], 1) << i << " of " << count;
  }
  std::atomic<int> inner{0};
  for_each_in_parallel(40, [&](size_t) { for_each_in_parallel(40, [&](size_t) { ++inner; }); });
  EXPECT_EQ(inner, 1600);
}

TEST(ForEachInParallel, ThrowsWhatATurnThrewAndServesTheNextCall) {
  EXPECT_THROW(for_each_in_parallel(1000,
                                    [](size_t i) {
                                      if (i == 500) throw std::runtime_error("turn 500");
                                    }),
               std::runtime_error);
  std::atomic<int> taken{0};
  for_each_in_parallel(1000, [&](size_t) { ++taken; });
  EXPECT_EQ(taken, 1000);
}

}  // namespace
}  // namespace inkbench
