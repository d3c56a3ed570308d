// SPDX-License-Identifier: MIT
#include "studies/report/scaling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace inkbench {
namespace {

TEST(Scaling, own_size_gives_the_picture_itself) {
  Picture picture(3, 2, 3);
  for (size_t i = 0; i < picture.samples.size(); ++i) picture.samples[i] = static_cast<uint8_t>(i * 13);
  EXPECT_EQ(scaled(picture, 3, 2), picture);
}

TEST(Scaling, flat_picture_keeps_each_of_its_256_codes) {
  for (int code = 0; code < 256; ++code) {
    const auto value = static_cast<uint8_t>(code);
    EXPECT_EQ(scaled(Picture(17, 13, 1, value), 5, 7), Picture(5, 7, 1, value));
    EXPECT_EQ(scaled(Picture(5, 7, 1, value), 17, 13), Picture(17, 13, 1, value));
  }
}

TEST(Scaling, black_and_white_mix_to_half_the_light) {
  Picture picture(2, 1, 1);
  picture.samples = {0, 255};
  EXPECT_EQ(scaled(picture, 1, 1).samples,
            (std::vector<uint8_t>{188}));  // sRGB code of 0.5; its mean code is 128.
}

TEST(Scaling, pixels_count_by_the_area_they_cover) {
  Picture picture(3, 1, 1);
  picture.samples = {255, 0, 0};
  // The first of two new pixels covers the white one and half a black one: 2/3 of the light.
  EXPECT_EQ(scaled(picture, 2, 1).samples, (std::vector<uint8_t>{213, 0}));
}

TEST(Scaling, nothing_leaves_the_range_beside_an_edge) {
  Picture picture(64, 64, 1, 100);
  for (int y = 0; y < 64; ++y) {
    for (int x = 30; x < 64; ++x) picture.at(x, y) = 200;
  }
  EXPECT_THAT(scaled(picture, 23, 23).samples,
              testing::Each(testing::AllOf(testing::Ge(100), testing::Le(200))));
}

TEST(Scaling, columns_made_alone_are_those_of_the_whole) {
  Picture picture(101, 7, 3);
  for (size_t i = 0; i < picture.samples.size(); ++i) picture.samples[i] = static_cast<uint8_t>(i * i >> 3);
  const Picture whole = scaled(picture, 40, 3);
  const Samples wanted{11, 13};
  const int first = covered_samples(101, 40, wanted.first).first;
  Picture part(covered_samples(101, 40, wanted.end - 1).end - first, 7, 3);
  for (int y = 0; y < 7; ++y) std::copy_n(&picture.at(first, y), part.width_px * 3, &part.at(0, y));
  const Picture columns = scaled_columns(part, first, {101, 40, 3}, wanted);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 2; ++x) {
      for (int i = 0; i < 3; ++i) EXPECT_EQ(columns.at(x, y, i), whole.at(wanted.first + x, y, i));
    }
  }
}

TEST(Scaling, whole_factor_up_repeats_pixels) {
  Picture picture(2, 1, 3);
  picture.samples = {1, 2, 3, 200, 210, 220};
  EXPECT_EQ(scaled(picture, 4, 1).samples,
            (std::vector<uint8_t>{1, 2, 3, 1, 2, 3, 200, 210, 220, 200, 210, 220}));
}

}  // namespace
}  // namespace inkbench
