// SPDX-License-Identifier: MIT
// `explain`: the numbers are those of the picture, and what is no pixel is refused.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pipeline/image/image_file.h"
#include "tests/cli/cli_test.h"

namespace inkbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Explain : public CliTest {
 protected:
  nlohmann::json explained(int x, int y, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"explain", "--scene", scene_,
                                       "--json",  "--pixel", std::to_string(x) + "," + std::to_string(y)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return nlohmann::json::parse(inkbench(arguments).out);
  }
  std::string scene_ = write("scene.toml", small_scene()).string();
};

TEST_F(Explain, gives_the_terms_behind_every_pixel_of_a_row) {
  ASSERT_TRUE(succeeds(inkbench(
      {"render", "--scene", scene_, "--buffers", "combined_edges", "--format", "exr", "--out", "out"})));
  const Image edges = read_image(file("out/combined_edges.exr"));
  const int y = edges.height_px / 2;
  int lines = 0;
  for (int x = 0; x < edges.width_px; x += 5) {
    const nlohmann::json why = explained(x, y);
    const double sum = why["terms"][0]["value"].get<double>() + why["terms"][1]["value"].get<double>();
    EXPECT_NEAR(why["sum"].get<double>(), sum, 1e-6) << x;
    EXPECT_NEAR(why["drawn"].get<double>(), edges.at(x, y), 1e-6) << x;
    const double edge = sum < why["limit"].get<double>() ? 0.0 : std::min(sum, 1.0);
    EXPECT_NEAR(edge, edges.at(x, y), 1e-5) << x;
    EXPECT_EQ(why["line"].get<bool>(), edges.at(x, y) != 0.0F) << x;
    EXPECT_EQ(why["class"].get<std::string>().empty(), edges.at(x, y) == 0.0F) << x;
    lines += why["line"].get<bool>();
  }
  EXPECT_GT(lines, 0);
}

TEST_F(Explain, reads_as_a_sentence_and_its_numbers) {
  const CommandResult result = inkbench({"explain", "--scene", scene_, "--pixel", "3, 4"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out,
              AllOf(StartsWith("Pixel 3, 4 by the detector 'paper'"), HasSubstr("the threshold 0.75"),
                    HasSubstr("Depth term: adds "), HasSubstr("gmax")));
}

TEST_F(Explain, follows_what_is_set) {
  EXPECT_FALSE(explained(3, 4, {"--set", "combine.use_depth=false"})["terms"][0]["used"].get<bool>());
}

/// A ball in the middle of 48 x 40 px.
constexpr const char* kBall =
    "[image]\nwidth = 48\nheight = 40\n[[model]]\nname = \"ball\"\nshape = \"sphere\"\nsegments = 24\n"
    "size = 2.5\n[[light]]\nname = \"sun\"\n";

TEST_F(Explain, says_what_would_draw_the_pixel_and_setting_it_does) {
  scene_ = write("ball.toml", kBall).string();
  const nlohmann::json why = explained(20, 20);
  ASSERT_EQ(why["changes"].size(), 3U) << why;
  for (const nlohmann::json& change : why["changes"]) {
    const std::string assignment = change["parameter"].get<std::string>() + "=" + change["value"].dump();
    EXPECT_LT(assignment.size(), 30U) << "few digits";
    EXPECT_TRUE(explained(20, 20, {"--set", assignment})["line"].get<bool>()) << assignment;
  }
}

TEST_F(Explain, says_why_a_pixel_is_false_and_nothing_of_one_that_is_right) {
  scene_ = write("ball.toml", kBall).string();
  const nlohmann::json wrong = explained(22, 20, {"--set", "combine.k_normal=0.001"})["judged"];
  ASSERT_TRUE(wrong.is_object());
  EXPECT_EQ(wrong["is"], "false");
  EXPECT_FALSE(wrong["remedy"].get<std::string>().empty());
  EXPECT_TRUE(explained(22, 20)["judged"].is_null());
}

TEST_F(Explain, refuses_what_is_no_pixel) {
  EXPECT_TRUE(
      is_input_error(inkbench({"explain", "--scene", scene_, "--pixel", "12"}), {"--pixel 12", "X,Y"}));
  EXPECT_TRUE(is_input_error(inkbench({"explain", "--scene", scene_, "--pixel", "1,2x"}), {"--pixel 1,2x"}));
  EXPECT_TRUE(is_input_error(inkbench({"explain", "--scene", scene_, "--pixel", "100000,0"}),
                             {"pixel 100000, 0", "not inside the image", "x is from 0 to "}));
}

TEST_F(Explain, passes_are_listed_with_what_they_take) {
  const CommandResult graph = inkbench({"passes", "--format", "dot"});
  EXPECT_THAT(graph.out, AllOf(StartsWith("digraph"), HasSubstr("gradient -> range;"),
                               HasSubstr("p_combine -> combine"), HasSubstr("final -> b_final;")));
}

}  // namespace
}  // namespace inkbench
