// SPDX-License-Identifier: MIT
// Ramps: exact at their stops, constant outside, stepped or smooth between.
#include "pipeline/settings/ramp.h"

#include <gmock/gmock.h>

#include <cmath>

#include "pipeline/image/image_file.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

const glm::vec3 kDark(0.1F, 0.2F, 0.3F);
const glm::vec3 kMiddle(0.4F);
const glm::vec3 kBright(1.0F, 0.9F, 0.8F);

Ramp three_stops(bool stepped) {
  return {{{0.25F, kDark, stepped}, {0.5F, kMiddle, stepped}, {0.75F, kBright, stepped}}, ""};
}

TEST(Ramp, has_each_stops_colour_exactly_at_the_stop) {
  for (const bool stepped : {true, false}) {
    EXPECT_EQ(evaluate_ramp(three_stops(stepped), 0.25F), kDark);
    EXPECT_EQ(evaluate_ramp(three_stops(stepped), 0.5F), kMiddle);
    EXPECT_EQ(evaluate_ramp(three_stops(stepped), 0.75F), kBright);
  }
}

TEST(Ramp, is_constant_before_the_first_and_after_the_last_stop) {
  for (const bool stepped : {true, false}) {
    EXPECT_EQ(evaluate_ramp(three_stops(stepped), 0.0F), kDark);
    EXPECT_EQ(evaluate_ramp(three_stops(stepped), std::nextafter(0.25F, 0.0F)), kDark);
    EXPECT_EQ(evaluate_ramp(three_stops(stepped), 1.0F), kBright);
  }
}

TEST(Ramp, a_stepped_stop_holds_until_the_next) {
  EXPECT_EQ(evaluate_ramp(three_stops(true), 0.4F), kDark);
  EXPECT_EQ(evaluate_ramp(three_stops(true), std::nextafter(0.5F, 0.0F)), kDark);
  EXPECT_EQ(evaluate_ramp(three_stops(true), std::nextafter(0.75F, 0.0F)), kMiddle);
}

TEST(Ramp, a_smooth_stop_blends_into_the_next) {
  const glm::vec3 halfway = evaluate_ramp(three_stops(false), 0.375F);
  const glm::vec3 quarter = evaluate_ramp(three_stops(false), 0.5625F);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(halfway[i], (kDark[i] + kMiddle[i]) / 2, 1e-6F);
    EXPECT_NEAR(quarter[i], kMiddle[i] + (kBright[i] - kMiddle[i]) / 4, 1e-6F);
  }
}

TEST(Ramp, stops_may_mix_both) {
  const Ramp ramp{{{0.0F, kDark, true}, {0.5F, kMiddle, false}, {1.0F, kBright, true}}, ""};
  EXPECT_EQ(evaluate_ramp(ramp, 0.25F), kDark);
  EXPECT_NE(evaluate_ramp(ramp, 0.75F), kMiddle);
}

TEST(Ramp, of_two_stops_at_one_place_the_later_holds_there) {
  const Ramp ramp{
      {{0.0F, kDark, false}, {0.5F, kMiddle, false}, {0.5F, kBright, false}, {1.0F, kDark, false}}, ""};
  EXPECT_EQ(evaluate_ramp(ramp, 0.5F), kBright);
  const glm::vec3 just_before = evaluate_ramp(ramp, std::nextafter(0.5F, 0.0F));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(just_before[i], kMiddle[i], 1e-5F);
}

TEST(Ramp, without_stops_brightness_stays_as_it_is) {
  EXPECT_EQ(evaluate_ramp(Ramp{}, 0.3F), glm::vec3(0.3F));
}

TEST(RampTable, samples_the_middle_of_each_texel) {
  const std::vector<glm::vec3> table = ramp_table(three_stops(true));
  ASSERT_EQ(table.size(), static_cast<size_t>(kRampTexels));
  EXPECT_EQ(table[511], kDark);
  EXPECT_EQ(table[512], kMiddle) << "a step at 0.5 lies between texels 511 and 512";
  EXPECT_EQ(table[767], kMiddle);
  EXPECT_EQ(table[768], kBright);
}

class RampImage : public ::testing::Test {
 protected:
  std::vector<glm::vec3> table_of(const Picture& picture) {
    write_png(folder_.path() / "ramp.png", picture, {});
    return ramp_table({{}, (folder_.path() / "ramp.png").string()});
  }
  const TemporaryFolder folder_;
};

TEST_F(RampImage, is_the_first_row_spread_over_the_table) {
  Picture picture(2, 2, 3, 255);
  for (int c = 0; c < 3; ++c) picture.at(0, 0, c) = static_cast<uint8_t>(51 * c);
  for (int c = 0; c < 3; ++c) picture.at(1, 0, c) = 51;
  const std::vector<glm::vec3> table = table_of(picture);
  ASSERT_EQ(table.size(), static_cast<size_t>(kRampTexels));
  for (const int texel : {0, 511}) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(table[texel][c], 0.2F * static_cast<float>(c), 1e-6F);
  }
  for (const int texel : {512, 1023}) EXPECT_NEAR(table[texel].y, 0.2F, 1e-6F);
}

TEST_F(RampImage, of_one_channel_is_grey) {
  const std::vector<glm::vec3> table = table_of(Picture(1, 1, 1, 51));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(table[1023][c], 0.2F, 1e-6F);
}

TEST_F(RampImage, wider_than_the_table_is_sampled_within_its_width) {
  Picture picture(5000, 1, 1, 0);
  picture.at(4997, 0) = 255;  // floor(1023.5 * 5000 / 1024)
  EXPECT_EQ(table_of(picture)[1023].x, 1.0F);
}

TEST_F(RampImage, missing_is_an_input_error) {
  EXPECT_THAT(error_of([&] {
                ramp_table({{}, (folder_.path() / "none.png").string()});
              }),
              ::testing::HasSubstr("none.png"));
}

}  // namespace
}  // namespace inkbench
