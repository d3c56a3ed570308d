// SPDX-License-Identifier: MIT
// Counting a buffer's values into bins, and how high the bars are.
#include "app/workbench/value_histogram.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace inkbench {
namespace {

Image values(std::vector<float> samples, int channels = 1) {
  Image image(static_cast<int>(samples.size()) / channels, 1, channels);
  image.samples = std::move(samples);
  return image;
}

TEST(ValueHistogram, bins_divide_the_range_and_the_largest_value_is_in_the_last) {
  const ValueHistogram histogram = histogram_of(values({0, 0.1F, 0.24F, 0.26F, 0.5F, 0.99F, 1}), 4);
  EXPECT_EQ(histogram.low, 0.0F);
  EXPECT_EQ(histogram.high, 1.0F);
  EXPECT_EQ(histogram.channels, (std::vector<std::vector<int64_t>>{{3, 1, 1, 2}}));
  EXPECT_EQ(histogram.largest(), 3);
}

TEST(ValueHistogram, channels_share_the_range_but_not_the_counts) {
  const ValueHistogram histogram = histogram_of(values({0, 2, 0, 4}, 2), 2);
  EXPECT_EQ(histogram.channels, (std::vector<std::vector<int64_t>>{{2, 0}, {0, 2}}));
  EXPECT_EQ(histogram.high, 4.0F);
}

TEST(ValueHistogram, what_is_not_finite_counts_nowhere) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const ValueHistogram histogram = histogram_of(values({1, infinity, nan, -infinity, 3}), 8);
  EXPECT_EQ(histogram.low, 1.0F);
  EXPECT_EQ(histogram.high, 3.0F);
  const std::vector<int64_t>& counts = histogram.channels[0];
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), int64_t{0}), 2);
  const ValueHistogram none = histogram_of(values({nan, infinity}), 8);
  EXPECT_EQ(none.low, 0.0F);
  EXPECT_EQ(none.high, 0.0F);
  EXPECT_EQ(none.largest(), 0);
}

TEST(ValueHistogram, equal_values_are_all_in_the_first_bin) {
  EXPECT_EQ(histogram_of(values({7, 7, 7}), 3).channels[0], (std::vector<int64_t>{3, 0, 0}));
}

TEST(ValueHistogram, the_widest_range_of_floats_does_not_overflow) {
  const float huge = std::numeric_limits<float>::max();
  EXPECT_EQ(histogram_of(values({-huge, 0, huge}), 2).channels[0], (std::vector<int64_t>{1, 2}));
}

TEST(BarHeight, is_a_share_of_the_largest_and_with_log_shows_single_pixels) {
  EXPECT_EQ(bar_height(0, 10, false), 0.0F);
  EXPECT_EQ(bar_height(5, 10, false), 0.5F);
  EXPECT_EQ(bar_height(10, 10, true), 1.0F);
  EXPECT_EQ(bar_height(0, 10, true), 0.0F);
  EXPECT_GT(bar_height(1, 1000000, true), 0.04F);
  EXPECT_LT(bar_height(1, 1000000, false), 0.001F);
  EXPECT_EQ(bar_height(0, 0, true), 0.0F);
}

}  // namespace
}  // namespace inkbench
