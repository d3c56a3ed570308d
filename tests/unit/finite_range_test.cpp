// SPDX-License-Identifier: MIT
#include "pipeline/image/finite_range.h"

#include <gtest/gtest.h>

#include <limits>

namespace inkbench {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(FiniteRange, leaves_out_what_is_not_finite) {
  Image image(2, 1, 3);
  image.samples = {kNan, 0.5F, -kInfinity, -2.0F, kInfinity, 0.25F};
  const auto range = finite_range(image);
  ASSERT_TRUE(range);
  EXPECT_EQ(range->low, -2.0F);
  EXPECT_EQ(range->high, 0.5F);
}

TEST(FiniteRange, is_none_without_finite_samples) {
  EXPECT_FALSE(finite_range(Image()));
  EXPECT_FALSE(finite_range(Image(1, 1, 2, kNan)));
}

}  // namespace
}  // namespace inkbench
