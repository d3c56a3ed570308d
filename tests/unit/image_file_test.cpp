// SPDX-License-Identifier: MIT
#include "pipeline/image/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/image/png_chunks.h"
#include "tests/unit/file_size_limit.h"
#include "tests/unit/tiny_png.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using namespace std::string_literals;

class ImageFile : public testing::Test {
 protected:
  ImageFile()
      : folder_(fs::path(testing::TempDir()) / ("image_file_" + std::to_string(getpid()) + test_name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~ImageFile() override { fs::remove_all(folder_); }

  static std::string test_name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
  fs::path file(const std::string& name) const { return folder_ / name; }
  size_t files_in_folder() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}));
  }
  fs::path write(const std::string& name, const std::string& content) const {
    write_file_atomically(file(name), content);
    return file(name);
  }

 private:
  fs::path folder_;
};

/// Noise, so that nothing packs and no two samples are alike by chance of layout.
Picture noise(int width, int height, int channels, uint32_t seed = 1) {
  Picture picture(width, height, channels);
  for (uint8_t& sample : picture.samples) {
    seed = seed * 1664525U + 1013904223U;
    sample = static_cast<uint8_t>(seed >> 24);
  }
  return picture;
}

/// The message of the error that `action` throws, led by its kind; "" where it throws none.
template <class Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return (error.kind() == ErrorKind::input ? "input: " : "work: ") + std::string(error.what());
  }
  return "";
}

class PngChannels : public ImageFile, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(All, PngChannels, testing::Values(1, 3, 4));

TEST_P(PngChannels, png_reads_back_exactly) {
  const Picture picture = noise(37, 23, GetParam());
  write_png(file("p.png"), picture, {});
  EXPECT_EQ(read_picture(file("p.png"), GetParam()), picture);
}

TEST_P(PngChannels, png_in_strips_reads_back_exactly) {
  // The last strip takes several chunks of the file.
  const Picture strips[] = {noise(500, 1, GetParam(), 2), noise(500, 17, GetParam(), 3),
                            noise(500, 900, GetParam(), 4)};
  Picture whole(500, 918, GetParam());
  PngStripWriter writer(file("p.png"), 500, 918, GetParam(), {{"name", "value"}});
  auto end = whole.samples.begin();
  for (const Picture& strip : strips) {
    end = std::copy(strip.samples.begin(), strip.samples.end(), end);
    writer.write(strip);
  }
  EXPECT_FALSE(fs::exists(file("p.png")));
  writer.finish();
  EXPECT_EQ(read_picture(file("p.png"), GetParam()), whole);
  EXPECT_EQ(read_image_text(file("p.png"), "name"), "value");
}

TEST_F(ImageFile, png_with_transparent_pixels_keeps_their_colour) {
  Picture picture(2, 1, 4);
  picture.samples = {200, 100, 50, 0, 200, 100, 50, 1};
  write_png(file("p.png"), picture, {});
  EXPECT_EQ(read_picture(file("p.png"), 4), picture);
  EXPECT_EQ(read_picture(file("p.png"), 3).samples, (std::vector<uint8_t>{200, 100, 50, 200, 100, 50}));
}

TEST_F(ImageFile, png_row_zero_is_on_top) {
  Picture picture(1, 2, 1);
  picture.samples = {10, 200};
  write_png(file("p.png"), picture, {});
  EXPECT_EQ(read_image(file("p.png")).at(0, 0), 10 / 255.0F);
}

TEST_F(ImageFile, same_input_gives_same_bytes_at_any_time) {
  const Picture picture = noise(9, 9, 3);
  const Image image(9, 9, 3, 0.5F);
  const ImageText text = {{"inkbench:settings", "a = 1"}};
  write_png(file("1.png"), picture, text);
  write_exr(file("1.exr"), image, text);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // Times in metadata count seconds.
  write_png(file("2.png"), picture, text);
  write_exr(file("2.exr"), image, text);
  EXPECT_EQ(read_file(file("1.png")), read_file(file("2.png")));
  EXPECT_EQ(read_file(file("1.exr")), read_file(file("2.exr")));
}

TEST_F(ImageFile, text_reads_back_exactly_from_png_and_exr) {
  std::string long_text;
  while (long_text.size() < 20000) long_text += "combine.k_depth = 0.003\n";
  const ImageText text = {{"inkbench:settings", "a = 1\n\tb = 2\r\n\n trailing \n"},
                          {"inkbench:title",
                           "Kanten \xc3\xbc"
                           "ber Fl\xc3\xa4"
                           "chen \xe2\x89\xa5 3, \xe7\xb7\x9a"},
                          {"long", long_text},
                          {"long, not ASCII", long_text + "\xc3\xa9"},
                          {"empty", ""},
                          {"Title", "t"},
                          {"Author", "a"},
                          {"Description", "d"},
                          {"Software", "s"},
                          {"DateTime", "not a date"},
                          {"compression test", "rle"},
                          {std::string(79, 'n'), "a long name"}};
  write_png(file("t.png"), noise(4, 4, 3), text);
  write_exr(file("t.exr"), Image(4, 4, 1), text);
  for (const auto& [name, value] : text) {
    EXPECT_EQ(read_image_text(file("t.png"), name), value) << name;
    EXPECT_EQ(read_image_text(file("t.exr"), name), value) << name;
  }
  EXPECT_EQ(read_image_text(file("t.png"), "absent"), "");
}

TEST_F(ImageFile, png_ascii_text_is_in_the_chunk_every_program_reads) {
  write_png(file("t.png"), noise(4, 4, 3), {{"name", "value"}});
  EXPECT_THAT(read_file(file("t.png")), HasSubstr("\0\0\0\x0atEXtname\0value"s));
}

TEST_F(ImageFile, png_other_text_is_utf8_by_the_standard) {
  write_png(file("t.png"), noise(4, 4, 3), {{"name", "\xc3\xa9"}});
  EXPECT_THAT(read_file(file("t.png")), HasSubstr("\0\0\0\x0biTXtname\0\0\0\0\0\xc3\xa9"s));
}

TEST_F(ImageFile, exr_keeps_every_bit) {
  for (const int channels : {1, 3, 4}) {
    Image image(5, 40, channels);
    for (size_t i = 0; i < image.samples.size(); ++i)
      image.samples[i] = static_cast<float>(i) * 1e-30F - 3e-29F;
    image.samples[0] = std::numeric_limits<float>::quiet_NaN();
    image.samples[1] = std::numeric_limits<float>::infinity();
    image.samples[2] = -std::numeric_limits<float>::infinity();
    image.samples[3] = std::numeric_limits<float>::denorm_min();
    image.samples[4] = -0.0F;
    write_exr(file("i.exr"), image, {});
    const Image back = read_image(file("i.exr"));
    ASSERT_EQ(back.channels, channels);
    ASSERT_EQ(back.samples.size(), image.samples.size());
    for (size_t i = 0; i < image.samples.size(); ++i) {
      ASSERT_EQ(std::bit_cast<uint32_t>(back.samples[i]), std::bit_cast<uint32_t>(image.samples[i])) << i;
    }
  }
}

TEST_F(ImageFile, exr_names_its_channels_and_packs) {
  write_exr(file("y.exr"), Image(64, 64, 1), {});
  write_exr(file("rgba.exr"), Image(64, 64, 4), {});
  EXPECT_THAT(read_file(file("y.exr")), HasSubstr("chlist\0\x13\0\0\0Y\0"s));
  EXPECT_THAT(read_file(file("rgba.exr")), HasSubstr("chlist\0\x49\0\0\0A\0"s));
  EXPECT_THAT(read_file(file("y.exr")), HasSubstr("compression\0compression\0\x01\0\0\0\x03"s));  // 3: ZIP
}

TEST_F(ImageFile, channels_are_converted_as_documented) {
  Picture grey(2, 1, 1), colour(2, 1, 3);
  grey.samples = {7, 250};
  colour.samples = {255, 0, 0, 0, 255, 0};
  write_png(file("grey.png"), grey, {});
  write_png(file("colour.png"), colour, {});
  EXPECT_EQ(read_picture(file("grey.png"), 3).samples, (std::vector<uint8_t>{7, 7, 7, 250, 250, 250}));
  EXPECT_EQ(read_picture(file("grey.png"), 4).samples,
            (std::vector<uint8_t>{7, 7, 7, 255, 250, 250, 250, 255}));
  EXPECT_EQ(read_picture(file("colour.png"), 4).samples,
            (std::vector<uint8_t>{255, 0, 0, 255, 0, 255, 0, 255}));
  EXPECT_EQ(read_picture(file("colour.png"), 1).samples, (std::vector<uint8_t>{54, 182}));
}

TEST_F(ImageFile, palette_and_16_bit_png_are_read) {
  write("palette.png", tiny_png(2, 1, 8, 3, png_chunk("PLTE", "\x01\x02\x03\xf0\xf1\xf2"), "\0\x01\0"s));
  write("deep.png", tiny_png(2, 1, 16, 0, "", "\0\x80\x80\xff\xff"s));
  write("grey_alpha.png", tiny_png(2, 1, 8, 4, "", "\0\x10\x20\x30\0"s));
  EXPECT_EQ(read_picture(file("palette.png"), 3).samples, (std::vector<uint8_t>{0xf0, 0xf1, 0xf2, 1, 2, 3}));
  EXPECT_EQ(read_picture(file("deep.png"), 1).samples, (std::vector<uint8_t>{0x80, 0xff}));
  EXPECT_FLOAT_EQ(read_image(file("deep.png")).at(0, 0), 0x8080 / 65535.0F);
  EXPECT_EQ(read_picture(file("grey_alpha.png"), 4).samples,
            (std::vector<uint8_t>{0x10, 0x10, 0x10, 0x20, 0x30, 0x30, 0x30, 0}));
}

TEST_F(ImageFile, absurd_size_in_a_header_is_refused_without_trying) {
  write("huge.png", tiny_png(1000000, 1000000, 8, 2, "", "\0\0\0\0"s));
  EXPECT_THAT(error_of([&] { read_picture(file("huge.png"), 3); }), HasSubstr("1000000 x 1000000"));
}

TEST_F(ImageFile, files_that_are_no_image_are_input_errors_that_name_the_file) {
  fs::create_directories(file("folder.png"));
  write("empty.png", "");
  write("junk.png", "this is not an image");
  write("junk.jpg", std::string(5000, '\x5a'));
  write("junk.exr", "\x76\x2f\x31\x01\x02\0\0\0junk"s);
  write("junk.tga", std::string(200, '\xff'));
  write("junk", std::string(5000, 'x'));
  for (const std::string name :
       {"missing.png", "folder.png", "empty.png", "junk.png", "junk.jpg", "junk.exr", "junk.tga", "junk"}) {
    EXPECT_THAT(error_of([&] { read_picture(file(name), 3); }),
                testing::StartsWith("input: " + file(name).string()));
    EXPECT_THAT(error_of([&] { read_image_text(file(name), "x"); }), testing::StartsWith("input: ")) << name;
  }
}

TEST_F(ImageFile, image_cut_off_anywhere_is_an_input_error) {
  write_png(file("whole.png"), noise(64, 64, 3), {{"settings", "a = 1"}});
  write_exr(file("whole.exr"), Image(64, 64, 3, 0.1F), {});
  for (const std::string ending : {".png", ".exr"}) {
    const std::string whole = read_file(file("whole" + ending));
    for (const double share : {0.001, 0.01, 0.1, 0.5, 0.9, 0.999}) {
      const auto keep = static_cast<size_t>(static_cast<double>(whole.size()) * share);
      write("cut" + ending, whole.substr(0, keep));
      EXPECT_THAT(error_of([&] { read_picture(file("cut" + ending), 3); }), testing::StartsWith("input: "))
          << ending << ' ' << keep << " bytes of " << whole.size();
    }
    write("cut" + ending, whole.substr(0, whole.size() - 1));
    EXPECT_NE(error_of([&] { read_picture(file("cut" + ending), 3); }), "") << ending;
  }
}

TEST_F(ImageFile, png_damaged_inside_is_an_input_error) {
  write_png(file("p.png"), noise(64, 64, 3), {});
  std::string content = read_file(file("p.png"));
  content[content.size() / 2] = static_cast<char>(content[content.size() / 2] ^ 0x55);
  write("p.png", content);
  EXPECT_THAT(error_of([&] { read_picture(file("p.png"), 3); }),
              HasSubstr("p.png: is damaged: a check sum is wrong"));
}

TEST_F(ImageFile, full_disk_is_a_work_error_and_leaves_nothing) {
  const Picture picture = noise(256, 256, 3);
  const Image image(512, 512, 3, 0.0F);
  Image raw = image;
  for (size_t i = 0; i < raw.samples.size(); ++i) raw.samples[i] = std::sin(static_cast<float>(i * i % 7919));
  std::string png_error, exr_error;
  {
    const FileSizeLimit limit(50000);
    png_error = error_of([&] { write_png(file("p.png"), picture, {}); });
    exr_error = error_of([&] { write_exr(file("i.exr"), raw, {}); });
  }
  EXPECT_THAT(png_error, testing::StartsWith("work: " + file("p.png").string()));
  EXPECT_THAT(exr_error, testing::StartsWith("work: " + file("i.exr").string()));
  EXPECT_EQ(files_in_folder(), 0U);
  write_png(file("p.png"), picture, {});
  EXPECT_EQ(read_picture(file("p.png"), 3), picture);
}

TEST_F(ImageFile, full_disk_stops_a_strip_writer_early) {
  PngStripWriter writer(file("p.png"), 4096, 4096, 3, {});
  const Picture strip = noise(4096, 64, 3);
  const FileSizeLimit limit(50000);
  EXPECT_THAT(error_of([&] { writer.write(strip); }), testing::StartsWith("work: "));
}

TEST_F(ImageFile, strip_writer_that_is_not_finished_leaves_nothing) {
  {
    PngStripWriter writer(file("p.png"), 16, 16, 3, {});
    writer.write(noise(16, 8, 3));
  }
  { const PngStripWriter writer(file("q.png"), 16, 16, 3, {}); }
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(ImageFile, old_picture_stays_when_the_new_one_fails) {
  const Picture old = noise(8, 8, 3);
  write_png(file("p.png"), old, {});
  {
    const FileSizeLimit limit(5000);
    EXPECT_NE(error_of([&] { write_png(file("p.png"), noise(256, 256, 3), {}); }), "");
  }
  EXPECT_EQ(read_picture(file("p.png"), 3), old);
}

TEST_F(ImageFile, folder_that_cannot_be_made_is_a_work_error) {
  write("plain", "x");
  EXPECT_THAT(error_of([&] { write_png(file("plain") / "p.png", noise(4, 4, 3), {}); }),
              testing::StartsWith("work: "));
}

TEST_F(ImageFile, threads_write_and_read_at_once) {
  std::vector<std::thread> threads;
  std::vector<int> good(4, 0);
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 10; ++i) {
        const std::string name = std::to_string(t) + "_" + std::to_string(i);
        const Picture picture = noise(61, 33, 3, static_cast<uint32_t>(t * 100 + i));
        write_png(file(name + ".png"), picture, {{"n", name}});
        write_exr(file(name + ".exr"), Image(31, 17, 3, static_cast<float>(i)), {});
        good[t] += read_picture(file(name + ".png"), 3) == picture &&
                   read_image(file(name + ".exr")).at(3, 4) == i &&
                   read_image_text(file(name + ".png"), "n") == name;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(good, testing::Each(10));
}

TEST(PngChunks, file_is_whole_only_with_its_end) {
  EXPECT_FALSE(png_is_whole("\x89PNG\r\n\x1a\n"));
  EXPECT_FALSE(png_is_whole("\x89PNG\r\n\x1a\n\xff\xff\xff\xff IEND"s));
  EXPECT_TRUE(png_is_whole("\x89PNG\r\n\x1a\n\0\0\0\0IEND\xae\x42\x60\x82"s));
}

TEST(PngChunks, each_byte_of_a_chunk_is_in_its_check_sum) {
  const std::string head = "\x89PNG\r\n\x1a\n"s;
  const std::string good = png_text_chunk("name", "text") + "\0\0\0\0IEND\xae\x42\x60\x82"s;
  EXPECT_TRUE(png_sums_are_right(head + good));
  for (size_t i = 4; i < good.size(); ++i) {  // behind the length
    if (i >= good.size() - 12 && i < good.size() - 8) continue;
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 1);
    EXPECT_FALSE(png_sums_are_right(head + bad)) << i;
  }
  EXPECT_TRUE(png_sums_are_right(head)) << "no chunk, no wrong sum";
  EXPECT_TRUE(png_sums_are_right(head + "\xff\xff\xff\xffIDATx----"s)) << "not whole";
}

}  // namespace
}  // namespace inkbench
