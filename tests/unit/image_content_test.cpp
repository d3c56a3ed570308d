// SPDX-License-Identifier: MIT
// What is seen of an image file before it is decoded: its format, whether it is whole, whether its size can
// be.
#include "pipeline/image/image_content.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <string>

#include "pipeline/base/files.h"
#include "pipeline/image/image_file.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

std::string number(int32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(static_cast<uint32_t>(value) >> shift);
  return bytes;
}

std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + '\0' + type + '\0' + number(static_cast<int32_t>(value.size())) + value;
}

std::string window(int32_t left, int32_t top, int32_t right, int32_t bottom) {
  return attribute("dataWindow", "box2i", number(left) + number(top) + number(right) + number(bottom));
}

std::string exr(const std::string& headers, bool several = false) {
  return "\x76\x2f\x31\x01" + number(several ? 2 | 1 << 12 : 2) + headers;
}

TEST(ImageContent, formats_are_told_by_their_first_bytes_alone) {
  EXPECT_EQ(image_format("\x89PNG\r\n\x1a\n..."), "png");
  EXPECT_EQ(image_format("\xff\xd8\xff\xe0"), "jpeg");
  EXPECT_EQ(image_format(exr("")), "openexr");
  EXPECT_EQ(image_format("II*\0"s), "tiff");
  EXPECT_EQ(image_format("MM\0*"s), "tiff");
  EXPECT_EQ(image_format("P5 1 1 255 x"), "pnm");
  for (const std::string& other : {""s, "GIF89a"s, "BM"s, "FOR4"s, "II*"s, "\x89PN"s, "P3"s})
    EXPECT_EQ(image_format(other), "");
}

TEST(ImageContent, an_exr_header_that_runs_past_the_end_is_cut_off) {
  const std::string whole = exr(window(0, 0, 3, 3) + attribute("owner", "string", "me") + '\0');
  EXPECT_FALSE(is_cut_off(whole + "pixels"));
  for (size_t size = 4; size < whole.size(); ++size) EXPECT_TRUE(is_cut_off(whole.substr(0, size))) << size;
  EXPECT_TRUE(is_cut_off(exr("a\0string\0\xff\xff\xff\x7f"s + "x" + '\0')));
  EXPECT_TRUE(is_cut_off(exr("a\0string\0\xff\xff\xff\xff"s + "x" + '\0')));
  const std::string header = window(0, 0, 3, 3) + '\0';
  EXPECT_FALSE(is_cut_off(exr(header + header + '\0', true)));
  EXPECT_TRUE(is_cut_off(exr(header + header, true)));
}

TEST(ImageContent, an_exr_may_not_ask_for_more_than_the_limit) {
  EXPECT_TRUE(exr_size_is_sound(exr(window(0, 0, 99, 99) + '\0')));
  EXPECT_TRUE(exr_size_is_sound(exr(window(0, 0, (1 << 17) - 1, 0) + '\0')));
  EXPECT_FALSE(exr_size_is_sound(exr(window(0, 0, 1 << 17, 0) + '\0')));
  EXPECT_TRUE(exr_size_is_sound(exr(window(-5, -5, 5, 5) + '\0')));
  for (const std::string& bad :
       {window(0, 0, 1 << 20, 1 << 20), window(INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX),
        window(0, 0, -1, 5), window(9, 9, 5, 5)})
    EXPECT_FALSE(exr_size_is_sound(exr(bad + '\0')));
}

TEST(ImageContent, pixels_must_fit_into_the_bytes) {
  EXPECT_TRUE(can_hold("pnm", 1000, 8000));
  EXPECT_FALSE(can_hold("pnm", 1000, 9000));
  EXPECT_TRUE(can_hold("png", 1000, 8'000'000));
  EXPECT_FALSE(can_hold("png", 1000, 9'000'000));
  EXPECT_TRUE(can_hold("tiff", 1, uint64_t{1} << 30)) << "CCITT packs a row of any length into a bit";
}

TEST(ImageContent, the_emptiest_large_png_can_be_held) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "black.png";
  write_png(path, Picture(4000, 3000, 1, 0), {});
  EXPECT_LT(fs::file_size(path), 20'000U);
  EXPECT_EQ(read_picture(path, 1).height_px, 3000);
}

TEST(ImageContent, files_of_other_formats_and_of_impossible_sizes_are_refused) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& content) {
    const fs::path path = folder.write("x.png", content);
    return error_of([&] { read_picture(path, 1); });
  };
  EXPECT_THAT(refusal("GIF89a" + std::string(60, '\xfa')),
              HasSubstr("PNG, JPEG, EXR, TIFF, PGM and PPM are"));
  EXPECT_THAT(refusal("FOR4" + std::string(200, '\x01')), HasSubstr("not an image that can be read"));
  EXPECT_THAT(refusal("P5\n30000 30000\n255\n123"),
              HasSubstr("30000 x 30000 px do not fit into its 22 bytes"));
  EXPECT_THAT(refusal(exr(window(0, 0, 1 << 20, 1 << 20) + '\0')), HasSubstr("at most 2^30 are read"));
}

}  // namespace
}  // namespace inkbench
