// `inkbench score`: two line maps in, measures out.
#include <nlohmann/json.hpp>

#include "pipeline/image/image_file.h"
#include "tests/cli/cli_test.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

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
};

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

}  // namespace
}  // namespace inkbench
