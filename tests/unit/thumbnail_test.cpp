// SPDX-License-Identifier: MIT
#include "studies/report/thumbnail.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/image/image.h"
#include "studies/report/page.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

Picture noise_square(int side_px) {
  Picture picture(side_px, side_px, 3);
  uint32_t seed = 7;
  for (uint8_t& sample : picture.samples) {
    seed = seed * 1664525U + 1013904223U;
    sample = static_cast<uint8_t>(seed >> 24);
  }
  return picture;
}

/// One upright line of 2 px on a plain ground.
Picture line_picture(uint8_t ground, uint8_t line) {
  Picture picture(512, 512, 3, ground);
  for (int y = 0; y < 512; ++y) {
    for (int i = 0; i < 3; ++i) picture.at(200, y, i) = picture.at(201, y, i) = line;
  }
  return picture;
}

std::string decoded64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<uint32_t>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

/// By the library itself: WebP is a format that we write and do not read.
Picture decoded(const std::string& text) {
  const TemporaryFolder folder;
  const auto input = OIIO::ImageInput::open(folder.write("t.webp", decoded64(text)).string());
  EXPECT_TRUE(input) << OIIO::geterror();
  if (!input) return {};
  Picture picture(input->spec().width, input->spec().height, input->spec().nchannels);
  EXPECT_TRUE(input->read_image(0, 0, 0, picture.channels, OIIO::TypeDesc::UINT8, picture.samples.data()));
  return picture;
}

TEST(Thumbnail, is_the_picture_within_the_plans_side) {
  Picture picture(300, 100, 3, 200);
  const Picture small = decoded(thumbnail(picture, {64, 10'000, 1}));
  EXPECT_EQ(small.width_px, 64);
  EXPECT_EQ(small.height_px, 21);
  for (const uint8_t sample : small.samples) EXPECT_NEAR(sample, 200, 2);
}

TEST(Thumbnail, never_magnifies) {
  const Picture small = decoded(thumbnail(Picture(30, 1, 3, 10), {240, 10'000, 1}));
  EXPECT_EQ(small.width_px, 30);
  EXPECT_EQ(small.height_px, 1);
}

TEST(Thumbnail, thin_lines_stay_visible_on_light_and_on_dark_ground) {
  const Picture dark = decoded(thumbnail(line_picture(255, 0), {64, 10'000, 1}));
  const Picture light = decoded(thumbnail(line_picture(0, 255), {64, 10'000, 1}));
  EXPECT_LT(*std::min_element(dark.samples.begin(), dark.samples.end()), 205);
  EXPECT_GT(*std::max_element(light.samples.begin(), light.samples.end()), 90);
}

TEST(Thumbnail, that_takes_too_much_becomes_smaller_and_at_last_nothing) {
  const Picture picture = noise_square(256);
  const std::string full = thumbnail(picture, {240, 1'000'000, 1});
  const std::string cut = thumbnail(picture, {240, full.size() - 1, 1});
  EXPECT_LT(cut.size(), full.size());
  EXPECT_EQ(decoded(cut).width_px, 180);
  EXPECT_EQ(thumbnail(picture, {240, 40, 1}), "");
  EXPECT_EQ(thumbnail(picture, {}), "");
}

TEST(Thumbnail, made_before_the_plan_is_known_is_what_any_plan_between_would_give) {
  const Picture picture = noise_square(256);
  const size_t full = thumbnail(picture, {240, 1'000'000, 1}).size();
  const ThumbnailPlan most{240, 1'000'000, 1}, least{180, full - 1, 1};
  const std::vector<Thumbnail> made = make_thumbnails(picture, most, least);
  for (const ThumbnailPlan& plan : {most, least, ThumbnailPlan{240, full - 1, 1}, {180, 1'000'000, 1}, {}})
    EXPECT_EQ(chosen_thumbnail(made, plan), thumbnail(picture, plan))
        << plan.side_px << " " << plan.max_chars;
}

TEST(Thumbnail, of_a_plan_outside_what_was_foreseen_is_not_among_those_made) {
  const std::vector<Thumbnail> made =
      make_thumbnails(noise_square(256), {180, 1'000'000, 1}, {128, 1'000'000, 1});
  EXPECT_EQ(made.size(), 2U);
  EXPECT_EQ(chosen_thumbnail(made, {240, 1'000'000, 1}), std::nullopt);
  EXPECT_EQ(chosen_thumbnail(made, {96, 1'000'000, 1}), std::nullopt);
  EXPECT_EQ(chosen_thumbnail({}, {96, 1'000'000, 1}), std::nullopt);
}

TEST(ThumbnailPlan, sides_shrink_with_the_count_and_all_fit) {
  constexpr size_t kRoom = 9'000'000;
  int last = 240;
  for (const size_t count : {1, 100, 500, 1000, 3000, 10'000}) {
    const ThumbnailPlan plan = plan_thumbnails(count, 1, kRoom);
    EXPECT_LE(plan.side_px, last) << count;
    EXPECT_GE(plan.side_px, 32) << count;
    EXPECT_LE(plan.max_chars * count, kRoom) << count;
    last = plan.side_px;
  }
  EXPECT_EQ(plan_thumbnails(100, 1, kRoom).side_px, 240);
  EXPECT_LT(last, 64);
}

TEST(ThumbnailPlan, first_pictures_alone_where_all_would_be_tiny) {
  EXPECT_EQ(plan_thumbnails(100, 8, 9'000'000).per_cell, 8U);
  const ThumbnailPlan plan = plan_thumbnails(5000, 8, 9'000'000);
  EXPECT_EQ(plan.per_cell, 1U);
  EXPECT_GE(plan.side_px, 64);
  EXPECT_EQ(plan_thumbnails(5000, 8, 1000).side_px, 0);
}

/// The worst there can be: as many cells as a page takes, long rows, pictures that do not compress.
TEST(ThumbnailPlan, largest_page_stays_under_12_megabytes) {
  StudyPage page;
  page.views = {""};
  page.buffers = {"final"};
  for (int i = 0; i < 20; ++i) page.columns.push_back({"recall_silhouette", ColumnKind::number});
  for (size_t i = 0; i < kMaxPageCells; ++i) {
    const std::string number = std::to_string(100'000 + i);
    PageCell cell{
        "k_depth = 0.001, k_normal = " + number, "", {"cells/" + number + "_final.png"}, {}, {}, {}};
    cell.row.assign(20, "0.66797595543921" + number);
    page.cells.push_back(std::move(cell));
  }
  const ThumbnailPlan plan = plan_thumbnails(kMaxPageCells, 1, thumbnail_room(page));
  const std::string text = thumbnail(noise_square(64), plan);
  EXPECT_NE(text, "");
  for (PageCell& cell : page.cells) cell.thumbnails = {text};
  EXPECT_LT(page_html(page).size(), 12'000'000U);
}

}  // namespace
}  // namespace inkbench
