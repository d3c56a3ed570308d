// SPDX-License-Identifier: MIT
#include "studies/report/lettering.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace inkbench {
namespace {

using testing::Each;
using testing::ElementsAre;

TEST(Lettering, width_is_the_sum_over_characters_in_any_script) {
  const auto width = [](const char* text) { return text_width_px(text, 20, Face::regular); };
  EXPECT_EQ(width("ab c"), width("a") + width("b") + width(" ") + width("c"));
  EXPECT_EQ(width("30\xc2\xb0"), width("30") + width("\xc2\xb0"));
  EXPECT_NE(width("\xc2\xb0"), width("0"));  // What remains of the sign without its first byte.
  EXPECT_EQ(width(""), 0);
  EXPECT_GT(text_width_px("ab", 20, Face::bold), width("ab"));
}

TEST(Lettering, lines_break_at_spaces_and_line_ends) {
  const int width = text_width_px("two words", 20, Face::regular);
  EXPECT_THAT(wrapped("two words and more", width, 20, Face::regular), ElementsAre("two words", "and more"));
  EXPECT_THAT(wrapped("two\nwords", width, 20, Face::regular), ElementsAre("two", "words"));
  EXPECT_THAT(wrapped("", width, 20, Face::regular), ElementsAre(""));
}

TEST(Lettering, word_wider_than_the_line_is_broken_between_characters) {
  const int width = text_width_px("\xc3\xa9\xc3\xa9\xc3\xa9", 20, Face::regular);
  const std::vector<std::string> lines =
      wrapped("\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9", width, 20, Face::regular);
  EXPECT_THAT(lines, ElementsAre("\xc3\xa9\xc3\xa9\xc3\xa9", "\xc3\xa9"));
  EXPECT_THAT(wrapped("abc", 1, 20, Face::regular), ElementsAre("a", "b", "c"));
}

TEST(Lettering, path_wider_than_the_line_is_broken_behind_a_folder) {
  const int width = text_width_px("folder/fi", 20, Face::regular);
  EXPECT_THAT(wrapped("folder/file.obj", width, 20, Face::regular), ElementsAre("folder/", "file.obj"));
}

TEST(Lettering, no_wrapped_line_is_wider_than_asked) {
  const std::string text = "k_depth = 0.003 and k_normal = 0.05, withoutanynormalmapwhatsoever, (too large)";
  for (int width = 40; width < 400; width += 7) {
    for (const std::string& line : wrapped(text, width, 17, Face::bold)) {
      EXPECT_LE(text_width_px(line, 17, Face::bold), width);
    }
  }
}

TEST(Lettering, fitting_prefers_a_little_smaller_to_another_line) {
  const std::vector<std::string> texts = {"two words"};
  const int width = text_width_px(texts[0], 20, Face::regular);
  EXPECT_EQ(fitted_size_px(texts, {width, 20, 10, 3}, Face::regular), 20);
  const int smaller = fitted_size_px(texts, {width, 24, 10, 3}, Face::regular);
  EXPECT_LE(smaller, 20);
  EXPECT_GE(smaller, 18);
  EXPECT_GT(fitted_size_px(texts, {width, 40, 10, 3}, Face::regular), 28);  // On two lines.
  EXPECT_EQ(fitted_size_px(texts, {3, 40, 10, 3}, Face::regular), 10);
}

TEST(Lettering, smallest_text_decides_for_all) {
  const std::vector<std::string> texts = {"a", "something a good deal longer"};
  const int size = fitted_size_px(texts, {150, 40, 5, 1}, Face::regular);
  EXPECT_LE(text_width_px(texts[1], size, Face::regular), 150);
  EXPECT_LT(size, 40);
}

TEST(Lettering, text_turned_upwards_is_the_same_ink_turned) {
  Picture flat(100, 100, 3, 255), turned(100, 100, 3, 255);
  draw_text(flat, 20, 60, "Ag", {30, Face::regular, {10, 20, 30}});
  draw_text(turned, 60, 79, "Ag", {30, Face::regular, {10, 20, 30}}, true);
  ASSERT_NE(flat, Picture(100, 100, 3, 255));
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) ASSERT_EQ(turned.at(y, 99 - x, 0), flat.at(x, y, 0)) << x << ' ' << y;
  }
}

TEST(Lettering, ink_has_the_colour_and_stays_near_its_line) {
  Picture picture(100, 60, 3, 255);
  draw_text(picture, 10, 40, "H", {30, Face::bold, {10, 20, 30}});
  std::array<uint8_t, 3> darkest = {255, 255, 255};
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 100; ++x) {
      for (int i = 0; i < 3; ++i) darkest[i] = std::min(darkest[i], picture.at(x, y, i));
      const bool near = y < 40 && y >= 10 && x >= 10 && x <= 40;
      EXPECT_TRUE(near || picture.at(x, y) == 255) << x << " " << y;
    }
  }
  EXPECT_THAT(darkest, ElementsAre(10, 20, 30));
}

TEST(Lettering, text_outside_the_picture_is_left_out) {
  Picture picture(10, 10, 3, 255);
  draw_text(picture, -500, -500, "far away", {20, Face::regular, {0, 0, 0}});
  draw_text(picture, 500, 5, "far away", {20, Face::regular, {0, 0, 0}}, true);
  EXPECT_THAT(picture.samples, Each(255));
}

}  // namespace
}  // namespace inkbench
