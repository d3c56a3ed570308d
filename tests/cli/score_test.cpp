// SPDX-License-Identifier: MIT
// `inkbench score`: two line maps in, measures out.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "pipeline/image/image_file.h"
#include "tests/cli/cli_test.h"
#include "tests/unit/tiny_png.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Score : public CliTest {
 protected:
  /// A white vertical line at x on black, 64 x 48 px.
  void write_line(const std::string& name, int x) const {
    Picture picture(64, 48, 1, 0);
    for (int y = 6; y < 42; ++y) picture.at(x, y) = 255;
    write_png(file(name), picture, {});
  }
  nlohmann::json scored(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all{"score"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.emplace_back("--json");
    const CommandResult result = inkbench(all);
    EXPECT_TRUE(succeeds(result));
    return nlohmann::json::parse(result.out);
  }
  /// Black, or white, of any size.
  void write_even(const std::string& name, int width, int height, uint8_t value = 0) const {
    write_png(file(name), Picture(width, height, 1, value), {});
  }
};

void expect_empty_and_perfect(const nlohmann::json& score) {
  EXPECT_EQ(score.at("empty"), true);
  for (const char* key : {"precision", "recall", "f1", "f1_t1", "f1_diag"})
    EXPECT_EQ(score.at(key), 1.0) << key;
  for (const char* key :
       {"matched", "predicted", "referenced", "chamfer", "baddeley", "hd95", "ink", "components"})
    EXPECT_EQ(score.at(key), 0.0) << key;
}

TEST_F(Score, line_beside_its_reference_matches_within_the_tolerance_only) {
  write_line("drawn.png", 30);
  write_line("wanted.png", 32);
  const nlohmann::json near = scored({"drawn.png", "wanted.png"});
  EXPECT_EQ(near.at("matched"), 36);
  EXPECT_EQ(near.at("f1"), 1.0);
  EXPECT_EQ(near.at("f1_t1"), 0.0);
  EXPECT_EQ(near.at("chamfer"), 2.0);
  EXPECT_EQ(near.at("empty"), false);
  EXPECT_EQ(scored({"drawn.png", "wanted.png", "--tolerance", "1"}).at("matched"), 0);
}

TEST_F(Score, json_is_one_object_and_nothing_else) {
  write_line("a.png", 30);
  const CommandResult result = inkbench({"score", "a.png", "a.png", "--json"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  EXPECT_TRUE(nlohmann::json::parse(result.out).is_object());
  EXPECT_THAT(result.err, IsEmpty());
}

TEST_F(Score, difference_picture_has_the_maps_size_or_more) {
  write_line("a.png", 30);
  write_line("b.png", 40);
  ASSERT_TRUE(succeeds(inkbench({"score", "a.png", "b.png", "--diff", "diff.png"})));
  const Picture picture = read_picture(file("diff.png"), 3);
  EXPECT_EQ(picture.width_px, 64);
  EXPECT_GE(picture.height_px, 48);
}

TEST_F(Score, bad_input_is_named) {
  write_line("a.png", 30);
  write_png(file("other.png"), Picture(32, 48, 1, 0), {});
  write("junk.png", "no picture");
  EXPECT_TRUE(is_input_error(inkbench({"score", "a.png", "other.png"}), {"64", "32"}));
  EXPECT_TRUE(is_input_error(inkbench({"score", "a.png", "missing.png"}), {"missing.png"}));
  EXPECT_TRUE(is_input_error(inkbench({"score", "junk.png", "a.png"}), {"junk.png"}));
  EXPECT_TRUE(is_input_error(inkbench({"score", "a.png", "a.png", "--tolerance", "-1"}), {"tolerance"}));
  EXPECT_TRUE(is_input_error(inkbench({"score", "a.png"}), {"REF"}));
}

TEST_F(Score, two_empty_maps_agree_and_say_so) {
  write_even("a.png", 64, 48);
  expect_empty_and_perfect(scored({"a.png", "a.png"}));
  const CommandResult table = inkbench({"score", "a.png", "a.png"});
  ASSERT_TRUE(succeeds(table));
  EXPECT_THAT(table.out, HasSubstr("empty: neither has a line"));
}

TEST_F(Score, one_empty_map_is_as_far_as_can_be) {
  write_line("line.png", 30);
  write_even("none.png", 64, 48);
  for (const auto& [drawn, wanted] : {std::pair{"line.png", "none.png"}, {"none.png", "line.png"}}) {
    const nlohmann::json score = scored({drawn, wanted});
    EXPECT_EQ(score.at("empty"), false);
    for (const char* key : {"matched", "precision", "recall", "f1", "f1_t1", "f1_diag"})
      EXPECT_EQ(score.at(key), 0.0);
    EXPECT_EQ(score.at("chamfer"), 10.0);
    EXPECT_EQ(score.at("baddeley"), 10.0);
    EXPECT_TRUE(score.at("hd95").is_null());
  }
}

TEST_F(Score, images_that_are_all_border_are_empty) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 3}, {1, 20000}}) {
    write_even("white.png", width, height, 255);
    expect_empty_and_perfect(scored({"white.png", "white.png", "--diff", "diff.png"}));
    EXPECT_EQ(read_picture(file("diff.png"), 3).width_px, width);
  }
}

TEST_F(Score, long_thin_images_are_measured) {
  Picture line(20000, 5, 1, 0);
  for (int x = 2; x < 19998; ++x) line.at(x, 2) = 255;
  write_png(file("line.png"), line, {});
  Picture short_line = line;
  for (int x = 100; x < 19998; ++x) short_line.at(x, 2) = 0;
  write_png(file("short.png"), short_line, {});
  const nlohmann::json score = scored({"short.png", "line.png"});
  EXPECT_EQ(score.at("referenced"), 19996);
  EXPECT_EQ(score.at("matched"), 98);
  EXPECT_EQ(score.at("precision"), 1.0);
  EXPECT_GT(score.at("hd95"), 18000.0);
}

TEST_F(Score, sizes_that_differ_are_both_named) {
  write_line("a.png", 30);
  for (const auto& [width, height] : {std::pair{48, 64}, {64, 47}, {1, 1}}) {
    write_even("b.png", width, height);
    EXPECT_TRUE(
        is_input_error(inkbench({"score", "a.png", "b.png", "--diff", "d.png"}),
                       {"a.png", "64 x 48", "b.png", fmt::format("{} x {}", width, height), "same size"}));
    EXPECT_FALSE(fs::exists(file("d.png")));
  }
}

TEST_F(Score, deep_and_transparent_images_score_as_plain_ones) {
  write_line("plain.png", 30);
  Picture transparent(64, 48, 4, 0);  // lines are black and seen
  std::string deep;
  for (int y = 0; y < 48; ++y) {
    deep += '\0';
    for (int x = 0; x < 64; ++x) {
      const bool is_line = x == 30 && y >= 6 && y < 42;
      deep += is_line ? "\x80\x01" : std::string("\x7f\x00", 2);
      transparent.at(x, y, 3) = is_line ? 255 : 0;
    }
  }
  write("deep.png", tiny_png(64, 48, 16, 0, "", deep));
  write_png(file("transparent.png"), transparent, {});
  for (const char* name : {"deep.png", "transparent.png"}) {
    const nlohmann::json score = scored({name, "plain.png", "--tolerance", "0"});
    EXPECT_EQ(score.at("matched"), 36) << name;
    EXPECT_EQ(score.at("f1"), 1.0) << name;
  }
}

TEST_F(Score, damaged_images_are_refused_in_one_line) {
  write_line("a.png", 30);
  const std::string whole = content_of(file("a.png"));
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 1);
  for (const std::string& bad :
       {std::string(), whole.substr(0, 20), whole.substr(0, whole.size() - 1),
        whole.substr(0, whole.size() / 2), damaged, "GIF89a" + std::string(60, '\xfa')}) {
    write("b.png", bad);
    EXPECT_TRUE(is_input_error(inkbench({"score", "a.png", "b.png"}), {"b.png"})) << bad.size();
  }
}

TEST_F(Score, tolerances_out_of_range_or_no_numbers_are_named) {
  write_line("a.png", 30);
  for (const char* bad : {"nan", "-1", "101", "1e400", "two", ""})
    EXPECT_TRUE(is_input_error(inkbench({"score", "a.png", "a.png", std::string("--tolerance=") + bad}),
                               {"--tolerance"}))
        << bad;
  for (const char* good : {"0", "100", "1e-400"})
    EXPECT_EQ(scored({"a.png", "a.png", std::string("--tolerance=") + good}).at("f1"), 1.0) << good;
}

TEST_F(Score, difference_picture_that_cannot_be_written_is_a_failure) {
  write_line("a.png", 30);
  fs::create_directories(file("folder"));
  for (const auto& [bad, place] :
       {std::pair{"folder", "folder"}, {"a.png/diff.png", "a.png"}, {"/proc/none/diff.png", "/proc/none"}}) {
    const CommandResult result = inkbench({"score", "a.png", "a.png", "--diff", bad});
    EXPECT_TRUE(is_work_error(result, {place}));
    EXPECT_THAT(result.out, IsEmpty()) << "no numbers beside a picture that is missing";
  }
  EXPECT_THAT(unfinished_files(file("")), IsEmpty());
}

}  // namespace
}  // namespace inkbench
