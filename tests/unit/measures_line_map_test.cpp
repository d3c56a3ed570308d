// SPDX-License-Identifier: MIT
// Line maps: from values and files, their border, and the bits past the width.
#include "pipeline/lines/line_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "pipeline/image/image_file.h"
#include "pipeline/line_file.h"
#include "support.h"
#include "tests/unit/tiny_png.h"

namespace inkbench {
namespace {

/// White lines on black, whichever is more.
LineMap light_lines(const std::filesystem::path& path) {
  return read_line_file(path, {.invert = Invert::no}).lines;
}

TEST(LineMap, over_127_is_line) {
  const TemporaryFolder folder;
  Picture grey(256, 1, 1);
  for (int x = 0; x < 256; ++x) grey.at(x, 0) = static_cast<uint8_t>(x);
  write_png(folder.path() / "grey.png", grey, {});
  const LineMap map = light_lines(folder.path() / "grey.png");
  EXPECT_EQ(map.count(), 128);
  EXPECT_FALSE(map.at(127, 0));
  EXPECT_TRUE(map.at(128, 0));
}

TEST(LineMap, a_value_at_the_cut_is_line_and_inverted_one_less_the_value) {
  Image image(256, 1, 1);
  for (int x = 0; x < 256; ++x) image.at(x, 0) = static_cast<float>(x) / 255.0F;
  for (const int step : {1, 51, 102, 204, 255}) {
    const double cut = step / 255.0;
    EXPECT_EQ(line_map_from(image, {cut}).count(), 256 - step) << step;
    EXPECT_EQ(line_map_from(image, {cut, true}).count(), 256 - step) << step;
    EXPECT_TRUE(line_map_from(image, {cut, true}).at(255 - step, 0)) << step;
  }
}

TEST(LineMap, a_cut_of_0_takes_whatever_is_above_it) {
  Image image(4, 1, 1);
  image.samples = {0.0F, 1e-30F, -1.0F, std::numeric_limits<float>::quiet_NaN()};
  EXPECT_EQ(pixels_of(line_map_from(image, {0.0})), (std::vector<Pixel>{{1, 0}}));
}

TEST(LineMap, png_reads_back_as_the_map) {
  const TemporaryFolder folder;
  std::mt19937 random(1);
  LineMap map(131, 17);
  for (int y = 0; y < 17; ++y) {
    for (int x = 0; x < 131; ++x) map.set(x, y, random() % 3 == 0);
  }
  write_png(folder.path() / "map.png", picture_of(map), {});
  EXPECT_EQ(light_lines(folder.path() / "map.png"), map);
}

TEST(LineMap, colour_counts_by_its_luma) {
  const TemporaryFolder folder;
  Picture colours(4, 1, 3);
  const uint8_t values[] = {255, 0, 0, /**/ 0, 255, 0, /**/ 0, 0, 255, /**/ 128, 128, 128};
  std::copy(std::begin(values), std::end(values), colours.samples.begin());
  write_png(folder.path() / "colours.png", colours, {});
  const LineMap map = light_lines(folder.path() / "colours.png");
  EXPECT_FALSE(map.at(0, 0));  // 54
  EXPECT_TRUE(map.at(1, 0));   // 182
  EXPECT_FALSE(map.at(2, 0));  // 18
  EXPECT_TRUE(map.at(3, 0));
}

TEST(LineMap, sixteen_bits_count_by_their_nearest_eight) {
  const TemporaryFolder folder;
  const std::string row("\0\x7f\x7f\x7f\xff\x80\x00\xff\xff", 9);
  const LineMap map = light_lines(folder.write("deep.png", tiny_png(4, 1, 16, 0, "", row)));
  EXPECT_FALSE(map.at(0, 0));  // 127
  EXPECT_FALSE(map.at(1, 0));  // 127.498
  EXPECT_TRUE(map.at(2, 0));   // 127.502
  EXPECT_TRUE(map.at(3, 0));
}

TEST(LineMap, transparency_is_white_below) {
  const TemporaryFolder folder;
  const std::string row("\0\xff\x00\xff\xff\x00\xff\x7f\xff\0\0\0\x40\0\xc0\x80\x80", 17);
  const LineMap map = light_lines(folder.write("alpha.png", tiny_png(8, 1, 8, 4, "", row)));
  const std::vector<bool> expected{true, true, false, false, true, true, false, true};
  for (int x = 0; x < 8; ++x) EXPECT_EQ(map.at(x, 0), expected[x]) << x;
}

TEST(LineMap, colours_of_an_exr_have_their_alpha_multiplied_in) {
  const TemporaryFolder folder;
  Image image(2, 1, 4, 0.25F);
  image.at(1, 0, 3) = 0.75F;  // 0.25 over white is 0.5
  image.at(0, 0, 3) = 0.8F;
  write_exr(folder.path() / "a.exr", image, {});
  EXPECT_EQ(pixels_of(light_lines(folder.path() / "a.exr")), (std::vector<Pixel>{{1, 0}}));
}

TEST(LineMap, one_bit_and_palette_images_are_maps) {
  const TemporaryFolder folder;
  const LineMap bits =
      light_lines(folder.write("bits.png", tiny_png(10, 1, 1, 0, "", std::string("\0\xa5\x40", 3))));
  for (int x = 0; x < 10; ++x) EXPECT_EQ(bits.at(x, 0), x == 0 || x == 2 || x == 5 || x == 7 || x == 9) << x;
  const std::string palette = png_chunk("PLTE", std::string("\xff\xff\xff\x00\x00\x00", 6));
  const LineMap white_is_0 =
      light_lines(folder.write("palette.png", tiny_png(2, 1, 8, 3, palette, std::string("\0\0\1", 3))));
  EXPECT_TRUE(white_is_0.at(0, 0));
  EXPECT_FALSE(white_is_0.at(1, 0));
}

TEST(LineMap, border_is_cleared_on_every_side_at_every_width) {
  for (const int width : {1, 4, 5, 63, 64, 65, 66, 67, 128, 130, 131}) {
    LineMap full(width, 9);
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < width; ++x) full.set(x, y);
    }
    const LineMap inside = without_border(full);
    EXPECT_EQ(inside.count(), std::max(0, width - 4) * 5);
    for_each_pixel(inside, [&](int x, int y) {
      EXPECT_TRUE(x >= 2 && y >= 2 && x < width - 2 && y < 7) << x << ' ' << y << " of " << width;
    });
  }
}

TEST(LineMap, pixels_come_row_by_row) {
  LineMap map(130, 3);
  for (const Pixel& pixel : {Pixel{129, 0}, Pixel{5, 2}, Pixel{64, 0}, Pixel{63, 0}})
    map.set(pixel.x, pixel.y);
  EXPECT_EQ(pixels_of(map), (std::vector<Pixel>{{63, 0}, {64, 0}, {129, 0}, {5, 2}}));
  map.set(64, 0, false);
  EXPECT_FALSE(map.at(64, 0));
  EXPECT_EQ(map.count(), 3);
}

}  // namespace
}  // namespace inkbench
