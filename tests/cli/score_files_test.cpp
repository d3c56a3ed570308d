// SPDX-License-Identifier: MIT
// What `inkbench score` takes for lines: files of other programs, dark on light or light on dark, and those
// that inkbench wrote, which give the same numbers whatever way they go.
#include <functional>
#include <nlohmann/json.hpp>

#include "pipeline/image/image_file.h"
#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ScoreFiles : public StudyTest {
 protected:
  /// A vertical line at x, 64 x 48 px, of `channels` (with alpha where they are even).
  void write_line(const std::string& name, int x, uint8_t line, uint8_t ground, int channels = 1) const {
    Picture picture(64, 48, channels, ground);
    for (int y = 6; y < 42; ++y) {
      for (int c = 0; c < std::min(channels, 3); ++c) picture.at(x, y, c) = line;
      if (channels == 4) picture.at(x, y, 3) = 255;
    }
    write_png(file(name), picture, {});
  }
  CommandResult score(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "score");
    arguments.emplace_back("--json");
    return inkbench(arguments);
  }
  nlohmann::json scored(const std::vector<std::string>& arguments) const {
    const CommandResult result = score(arguments);
    EXPECT_TRUE(succeeds(result));
    return nlohmann::json::parse(result.out);
  }
  void render(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"render", "--scene", "scene.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    ASSERT_TRUE(succeeds(inkbench(arguments)));
  }
};

/// Of each number that a study has and a score can have: the text of the one, the value of the other.
void expect_the_studys_numbers(const nlohmann::json& score, const std::map<std::string, std::string>& row) {
  int compared = 0;
  for (const auto& [column, text] : row) {
    if (!score.contains(column) || column == "jaggedness_px" || column == "bias_px") continue;
    EXPECT_EQ(score.at(column), text.empty() ? nlohmann::json() : nlohmann::json::parse(text)) << column;
    ++compared;
  }
  EXPECT_EQ(compared, 27);
}

TEST_F(ScoreFiles, png_exr_and_study_give_one_number) {
  // Lines of tier 2 that lie on others, a tolerance of its own, strengths that are no shares of ink.
  const std::string set =
      "[set]\njudge = { crease = \"allowed\", object = \"allowed\", tolerance = 1 }\n"
      "combine.threshold = 0.2\n";
  write_spec(
      "s",
      "size = [160, 120]\nshow = [\"lines\", \"reference\", \"combined_edges\"]\nmeasure = true\n" + set);
  ASSERT_TRUE(succeeds(study("s", "out")));
  const auto row = table("out").rows.at(0);
  ASSERT_GT(std::stod(row.at("f1")), 0.3);
  for (const char* format : {"png", "exr"})
    ASSERT_TRUE(succeeds(inkbench({"render", "--from", "out/cells/0001_lines.png", "--buffers",
                                   "lines,reference,combined_edges", "--format", format, "--out", "again"})));
  for (const auto& [drawn, wanted] : {std::pair{"out/cells/0001_lines.png", "out/cells/0001_reference.png"},
                                      {"again/lines.png", "again/reference.png"},
                                      {"again/lines.exr", "again/reference.exr"},
                                      {"again/lines.png", "again/reference.exr"},
                                      {"again/combined_edges.png", "again/reference.png"},
                                      {"again/combined_edges.exr", "again/reference.png"}}) {
    SCOPED_TRACE(drawn);
    const CommandResult result = score({drawn, wanted});
    ASSERT_TRUE(succeeds(result));
    EXPECT_THAT(result.err, IsEmpty());
    expect_the_studys_numbers(nlohmann::json::parse(result.out), row);
  }
}

TEST_F(ScoreFiles, tiers_of_the_reference_are_told) {
  render({"--set", "judge.crease=allowed", "--buffers", "lines,reference", "--out", "o"});
  const nlohmann::json reference = scored({"o/lines.png", "o/reference.png"}).at("reference");
  EXPECT_EQ(reference.at("buffer"), "reference");
  EXPECT_THAT(reference.at("wanted").get<std::vector<std::string>>(),
              ElementsAre("silhouette", "boundary", "object"));
  EXPECT_THAT(reference.at("allowed").get<std::vector<std::string>>(),
              ElementsAre("crease", "suggestive", "ridge", "valley"));
}

TEST_F(ScoreFiles, dark_lines_on_light_are_found_on_each_side_and_told) {
  write_line("light.png", 30, 255, 0);
  write_line("dark.png", 30, 0, 255);
  write_line("clear.png", 30, 0, 0, 4);
  for (const auto& [drawn, wanted] : {std::pair{"dark.png", "light.png"},
                                      {"light.png", "dark.png"},
                                      {"dark.png", "dark.png"},
                                      {"clear.png", "light.png"}}) {
    const CommandResult result = score({drawn, wanted});
    ASSERT_TRUE(succeeds(result));
    const nlohmann::json numbers = nlohmann::json::parse(result.out);
    EXPECT_EQ(numbers.at("matched"), 36) << drawn << ' ' << wanted;
    EXPECT_EQ(numbers.at("ink_px"), 36);
    for (const auto& [side, name] : {std::pair{"prediction", drawn}, {"reference", wanted}}) {
      const bool is_dark = std::string(name) != "light.png";
      EXPECT_EQ(numbers.at(side).at("inverted"), is_dark) << side;
      const std::string note = std::string(name) + " is read as dark lines on light";
      EXPECT_EQ(result.err.find(note) != std::string::npos, is_dark) << result.err;
      EXPECT_EQ(numbers.at("notes").dump().find(note) != std::string::npos, is_dark);
    }
  }
}

TEST_F(ScoreFiles, polarity_can_be_said) {
  write_line("light.png", 30, 255, 0);
  write_line("dark.png", 30, 0, 255);
  EXPECT_EQ(scored({"dark.png", "dark.png", "--invert", "yes"}).at("matched"), 36);
  EXPECT_THAT(score({"dark.png", "dark.png", "--invert", "yes"}).err, IsEmpty());
  const CommandResult taken = score({"dark.png", "light.png", "--invert", "no"});
  EXPECT_EQ(nlohmann::json::parse(taken.out).at("ink_px"), 64 * 48 - 36);
  EXPECT_THAT(taken.err, HasSubstr("dark.png is more than half line"));
  EXPECT_TRUE(is_input_error(score({"dark.png", "light.png", "--invert", "maybe"}), {"--invert", "auto"}));
}

TEST_F(ScoreFiles, soft_lines_need_a_cut_and_say_so) {
  write_line("soft.png", 30, 102, 0);
  write_line("dark.png", 30, 153, 255);
  write_line("light.png", 30, 255, 0);
  const CommandResult none = score({"soft.png", "light.png"});
  ASSERT_TRUE(succeeds(none));
  EXPECT_EQ(nlohmann::json::parse(none.out).at("predicted"), 0);
  EXPECT_THAT(none.err, HasSubstr("soft.png has no line: its lightest pixel has 0.4, and the cut is 0.5"));
  for (const char* soft : {"soft.png", "dark.png"}) {
    EXPECT_EQ(scored({soft, "light.png", "--cut", "0.4"}).at("matched"), 36) << "at the cut";
    EXPECT_EQ(scored({soft, "light.png", "--cut", "0.41"}).at("matched"), 0);
  }
  EXPECT_EQ(scored({"soft.png", "light.png", "--cut", "0"}).at("matched"), 36) << "above 0";
  for (const char* bad : {"nan", "-0.1", "1.1"})
    EXPECT_TRUE(
        is_input_error(score({"soft.png", "light.png", std::string("--cut=") + bad}), {"--cut", "0 to 1"}));
}

TEST_F(ScoreFiles, lines_that_inkbench_wrote_are_never_inverted_by_guess) {
  render({"--set", "combine.threshold=0", "--set", "camera.eye=[0, 8, 0.1]", "--buffers", "lines", "--out",
          "o"});
  const CommandResult result = score({"o/lines.png", "o/lines.png"});
  ASSERT_TRUE(succeeds(result));
  const nlohmann::json numbers = nlohmann::json::parse(result.out);
  ASSERT_GT(numbers.at("ink").get<double>(), 0.5);
  EXPECT_EQ(numbers.at("prediction").at("inverted"), false);
  EXPECT_THAT(result.err, HasSubstr("o/lines.png is more than half line"));
}

TEST_F(ScoreFiles, buffers_without_lines_are_refused) {
  render({"--buffers", "all", "--out", "o"});
  for (const char* buffer : {"final", "shaded", "normal", "depth", "normal_edges", "object_id"}) {
    const std::string name = std::string("o/") + buffer + ".png";
    EXPECT_TRUE(is_input_error(score({name, "o/reference.png"}), {name, buffer, "--buffers lines"}));
  }
}

TEST_F(ScoreFiles, a_reference_that_was_changed_or_does_not_say_all_classes_is_refused) {
  render({"--buffers", "lines,reference", "--out", "o"});
  Picture picture = read_picture(file("o/reference.png"), 3);
  ImageText text;
  for (const char* entry : {"inkbench:version", "inkbench:buffer", "inkbench:settings", "inkbench:classes"})
    text[entry] = read_image_text(file("o/reference.png"), entry);
  picture.at(5, 7, 1) = 254;  // white no longer
  write_png(file("changed.png"), picture, text);
  EXPECT_TRUE(
      is_input_error(score({"o/lines.png", "changed.png"}), {"changed.png", "pixel 5, 7", "changed"}));
  write_png(file("grey.png"), Picture(64, 48, 1, 255), text);
  EXPECT_TRUE(is_input_error(score({"o/lines.png", "grey.png"}), {"grey.png", "changed"}));
  text.erase("inkbench:classes");
  write_png(file("older.png"), picture, text);
  EXPECT_TRUE(is_input_error(score({"o/lines.png", "older.png"}), {"older.png", "another version"}));
}

}  // namespace
}  // namespace inkbench
