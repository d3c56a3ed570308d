// SPDX-License-Identifier: MIT
// `inkbench score --curve`: strength maps and drawings in, precision and recall over thresholds out.
#include <limits>
#include <nlohmann/json.hpp>

#include "pipeline/image/image_file.h"
#include "tests/cli/cli_test.h"
#include "tests/unit/mat_bytes.h"

namespace inkbench {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class ScoreCurve : public CliTest {
 protected:
  /// A horizontal line of 30 px at y on an even ground, 64 x 48 px.
  void write_line(const std::string& name, int y, uint8_t line = 255, uint8_t ground = 0) const {
    Picture picture(64, 48, 1, ground);
    for (int x = 10; x < 40; ++x) picture.at(x, y) = line;
    write_png(file(name), picture, {});
  }
  CommandResult score(const std::string& predictions, const std::string& references,
                      std::vector<std::string> more = {"--json"}) const {
    std::vector<std::string> arguments{"score", predictions, references, "--curve"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return inkbench(arguments);
  }
  nlohmann::json scored(const std::string& predictions, const std::string& references,
                        std::vector<std::string> more = {}) const {
    more.emplace_back("--json");
    const CommandResult result = score(predictions, references, more);
    EXPECT_TRUE(succeeds(result));
    return nlohmann::json::parse(result.out);
  }
  /// Two images, whose lines have strengths of 200 and 100 of 255.
  void write_set() const {
    write_line("pred/a.png", 10, 200);
    write_line("pred/b.png", 20, 100);
    write_line("ref/a.png", 10);
    write_line("ref/b.png", 20);
  }
};

TEST_F(ScoreCurve, folders_are_paired_by_name_and_pooled) {
  write_set();
  const nlohmann::json score = scored("pred", "ref");
  EXPECT_EQ(score.at("images"), 2);
  EXPECT_EQ(score.at("ods"), 1.0);
  EXPECT_EQ(score.at("curve").size(), 99U);
  EXPECT_EQ(score.at("curve")[38].at("recall"), 1.0);  // 0.39 x 255 = 99.45
  EXPECT_EQ(score.at("curve")[39].at("recall"), 0.5);
  EXPECT_EQ(score.at("curve")[78].at("recall"), 0.0);
}

TEST_F(ScoreCurve, several_annotators_lie_in_a_folder_of_the_images_name) {
  write_line("pred/a.png", 10);
  write_line("ref/a/1.png", 10);
  write_line("ref/a/2.png", 30);
  const nlohmann::json score = scored("pred", "ref");
  EXPECT_EQ(score.at("drawings"), 2);
  EXPECT_EQ(score.at("at_ods").at("precision"), 1.0);
  EXPECT_EQ(score.at("at_ods").at("recall"), 0.5);
  EXPECT_EQ(scored("pred/a.png", "ref/a").at("at_ods"), score.at("at_ods"));
}

TEST_F(ScoreCurve, the_ground_truth_of_bsds500_is_read_as_it_is) {
  std::vector<std::string> rows(48, std::string(64, '.'));
  rows[10].replace(10, 30, std::string(30, '#'));
  write("ref/a.mat", mat_file(mat_compressed(mat_ground_truth({mat_annotator({rows.begin(), rows.end()})}))));
  write_line("pred/a.png", 10, 128);
  EXPECT_EQ(scored("pred", "ref").at("ods"), 1.0);
}

TEST_F(ScoreCurve, the_way_of_a_side_is_decided_over_all_of_its_files) {
  write_line("pred/a.png", 10, 60, 255);
  write_line("pred/b.png", 20, 60, 255);
  Picture mostly_dark(64, 48, 1, 0);  // whose line lies between light ones: there is less of those
  for (const int y : {28, 29, 31, 32}) {
    for (int x = 0; x < 64; ++x) mostly_dark.at(x, y) = 255;
  }
  write_png(file("pred/c.png"), mostly_dark, {});
  write_line("ref/a.png", 10);
  write_line("ref/b.png", 20);
  write_line("ref/c.png", 30);
  const nlohmann::json score = scored("pred", "ref");
  EXPECT_EQ(score.at("prediction").at("inverted"), true);
  EXPECT_EQ(score.at("reference").at("inverted"), false);
  EXPECT_EQ(score.at("curve")[50].at("found"), 90);
}

TEST_F(ScoreCurve, transparent_is_no_line_on_light_or_dark_ones) {
  for (const uint8_t line : {uint8_t{0}, uint8_t{255}}) {
    Picture picture(64, 48, 4, line);
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) picture.at(x, y, 3) = y == 10 && x >= 10 && x < 40 ? 255 : 0;
    }
    write_png(file("drawn.png"), picture, {});
    write_line("wanted.png", 10);
    const nlohmann::json score = scored("drawn.png", "wanted.png", {"--invert", line == 0 ? "auto" : "no"});
    EXPECT_EQ(score.at("curve")[98].at("predicted"), 30) << int{line};
  }
}

TEST_F(ScoreCurve, floats_of_an_exr_keep_their_digits) {
  Image strengths(64, 48, 1);
  for (int x = 10; x < 40; ++x) strengths.at(x, 10) = 0.4249F;
  write_exr(file("drawn.exr"), strengths, {});
  write_line("wanted.png", 10);
  const nlohmann::json score = scored("drawn.exr", "wanted.png");
  EXPECT_EQ(score.at("curve")[41].at("predicted"), 30);
  EXPECT_EQ(score.at("curve")[42].at("predicted"), 0);
}

TEST_F(ScoreCurve, what_is_not_0_to_1_is_named_with_its_pixel) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), 3.5F, -1.0F}) {
    Image strengths(64, 48, 1);
    strengths.at(7, 3) = bad;
    write_exr(file("drawn.exr"), strengths, {});
    write_line("wanted.png", 10);
    EXPECT_TRUE(is_input_error(score("drawn.exr", "wanted.png"),
                               {"drawn.exr", "pixel 7, 3", "strengths are 0 to 1"}));
  }
}

TEST_F(ScoreCurve, an_exported_edge_strength_has_its_limit_at_a_half) {
  write("scene.toml", small_scene());
  for (const char* format : {"exr", "png"})
    ASSERT_TRUE(succeeds(inkbench({"render", "--scene", "scene.toml", "--buffers", "edge_strength,lines",
                                   "--format", format, "--out", "out"})));
  EXPECT_EQ(scored("out/edge_strength.exr", "out/lines.png").at("curve")[49].at("recall"), 1.0);
  EXPECT_TRUE(
      is_input_error(score("out/edge_strength.png", "out/lines.png"), {"edge_strength.png", "end at white"}));
}

TEST_F(ScoreCurve, a_file_without_a_partner_is_named) {
  write_set();
  write_line("pred/c.png", 10);
  EXPECT_TRUE(is_input_error(score("pred", "ref"), {"pred/c.png", "has no partner in ref"}));
  fs::remove(file("pred/c.png"));
  write_line("ref/d.png", 10);
  EXPECT_TRUE(is_input_error(score("pred", "ref"), {"ref/d.png", "has no partner in pred"}));
}

TEST_F(ScoreCurve, sizes_that_differ_are_refused_by_name) {
  write_set();
  write_png(file("ref/b.png"), Picture(64, 47, 1), {});
  EXPECT_TRUE(is_input_error(score("pred", "ref"), {"pred/b.png", "64 x 48", "ref/b.png is 64 x 47"}));
}

TEST_F(ScoreCurve, files_that_cannot_be_read_are_named) {
  write_set();
  write("pred/b.png", content_of(file("ref/b.png")).substr(0, 60));
  EXPECT_TRUE(is_input_error(score("pred", "ref"), {"pred/b.png", "cut off"}));
  write("pred/b.png", "no image");
  EXPECT_TRUE(is_input_error(score("pred", "ref"), {"pred/b.png", "is not an image that can be read"}));
}

TEST_F(ScoreCurve, two_files_of_one_name_are_refused) {
  write_set();
  write_exr(file("pred/a.exr"), Image(64, 48, 1), {});
  EXPECT_TRUE(is_input_error(score("pred", "ref"), {"pred/a.png", "has the name of a.exr"}));
}

TEST_F(ScoreCurve, folders_without_images_and_paths_that_are_not_there_are_refused) {
  write_set();
  fs::create_directories(file("none"));
  EXPECT_TRUE(is_input_error(score("none", "ref"), {"none", "holds no image"}));
  EXPECT_TRUE(is_input_error(score("pred", "elsewhere"), {"elsewhere", "does not exist"}));
  EXPECT_TRUE(is_input_error(score("pred", "ref/a.png"), {"ref/a.png", "is one file, but pred is a folder"}));
}

TEST_F(ScoreCurve, other_files_beside_the_images_are_left_out_with_a_note) {
  write_set();
  write("pred/notes.txt", "of mine");
  write("pred/.DS_Store", "x");
  const nlohmann::json score = scored("pred", "ref");
  EXPECT_THAT(score.at("notes"), Contains("pred: left out, being no images: notes.txt"));
}

TEST_F(ScoreCurve, a_folder_gets_the_curve_as_json_csv_and_chart) {
  write_set();
  ASSERT_TRUE(succeeds(score("pred", "ref", {"--out", "scores"})));
  const FolderContent files = folder_content(file("scores"));
  for (const char* name : {"score.json", "curve.csv", "images.csv", "curve.gp", "curve.svg", "curve.png"})
    EXPECT_TRUE(files.contains(name)) << name;
  EXPECT_EQ(nlohmann::json::parse(files.at("score.json")), scored("pred", "ref"));
  EXPECT_THAT(files.at("curve.csv"), HasSubstr("0.40,1,0.5,0.6666666666666666,30,30,60,30\n"));
  EXPECT_THAT(files.at("curve.svg"), HasSubstr("ODS 1.000"));
}

TEST_F(ScoreCurve, a_place_that_cannot_be_written_is_a_failure_of_work) {
  write_set();
  write("scores", "a file");
  EXPECT_TRUE(is_work_error(score("pred", "ref", {"--out", "scores"}), {"scores"}));
  EXPECT_THAT(unfinished_files(file(".")), IsEmpty());
}

TEST_F(ScoreCurve, options_of_single_lines_do_not_go_with_it) {
  write_set();
  EXPECT_TRUE(is_input_error(score("pred", "ref", {"--cut", "0.5"}), {"--curve", "--cut"}));
  EXPECT_TRUE(
      is_input_error(inkbench({"score", "pred/a.png", "ref/a.png", "--out", "x"}), {"--out", "--curve"}));
}

}  // namespace
}  // namespace inkbench
