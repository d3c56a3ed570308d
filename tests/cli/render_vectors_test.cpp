// SPDX-License-Identifier: MIT
// `inkbench render --format svg|pdf`: lines as vectors, and what of the options goes together.
#include "tests/cli/cli_test.h"

namespace inkbench {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class RenderVectors : public CliTest {
 protected:
  RenderVectors() { write("scene.toml", small_scene()); }

  CommandResult render(const std::string& out, std::vector<std::string> arguments,
                       const CommandOptions& options = {}) const {
    arguments.insert(arguments.begin(), {"render", "--scene", "scene.toml", "--out", out});
    return inkbench(arguments, options);
  }
};

TEST_F(RenderVectors, same_scene_gives_the_same_bytes) {
  const std::vector<std::string> arguments{"--buffers", "curves,strokes", "--format", "svg", "--regions"};
  ASSERT_TRUE(succeeds(render("one", arguments)));
  ASSERT_TRUE(succeeds(render("two", arguments)));
  EXPECT_EQ(folder_content(file("one")).size(), 2U);
  EXPECT_EQ(folder_content(file("one")), folder_content(file("two")));
}

TEST_F(RenderVectors, strokes_have_groups_for_the_scenes_models) {
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "strokes", "--format", "svg"})));
  const std::string svg = content_of(file("out/strokes.svg"));
  EXPECT_THAT(svg, AllOf(HasSubstr("width=\"64\" height=\"48\""), HasSubstr("<g id=\"strokes\">"),
                         ContainsRegex("<g id=\"[a-z]+-box\">"), Not(HasSubstr("regions"))));
}

TEST_F(RenderVectors, regions_lie_below_the_lines) {
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "curves", "--format", "svg", "--regions"})));
  const std::string svg = content_of(file("out/curves.svg"));
  EXPECT_LT(svg.find("<g id=\"regions\""), svg.find("<g id=\"curves\""));
}

TEST_F(RenderVectors, svg_file_is_where_a_picture_can_start_from) {
  ASSERT_TRUE(
      succeeds(render("out", {"--buffers", "strokes", "--format", "svg", "--set", "stroke.width=3.5"})));
  ASSERT_TRUE(
      succeeds(inkbench({"render", "--from", "out/strokes.svg", "--format", "svg", "--out", "again"})));
  EXPECT_EQ(content_of(file("out/strokes.svg")), content_of(file("again/strokes.svg")));
}

TEST_F(RenderVectors, pdf_has_no_date_of_now) {
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "strokes", "--format", "pdf"})));
  const std::string pdf = content_of(file("out/strokes.pdf"));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_THAT(pdf, HasSubstr("/CreationDate (D:19700101000000Z)"));
}

TEST_F(RenderVectors, pdf_without_rsvg_convert_names_its_package) {
  CommandOptions options;
  options.environment["PATH"] = file("nowhere").string();
  EXPECT_TRUE(is_work_error(render("out", {"--buffers", "strokes", "--format", "pdf"}, options),
                            {"rsvg-convert", "librsvg2-bin"}));
}

TEST_F(RenderVectors, centre_lines_are_in_millimetres_and_the_travel_is_told) {
  const CommandResult result =
      render("out", {"--buffers", "curves", "--format", "svg", "--centre-lines", "--plot-width", "120"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out,
              ContainsRegex("curves: [0-9]+ lines; lifted, the pen travels [0-9]+ mm, [0-9]+ mm before"));
  EXPECT_THAT(content_of(file("out/curves.svg")), HasSubstr("width=\"120mm\" height=\"90mm\""));
}

TEST_F(RenderVectors, options_that_do_not_go_together_say_so) {
  const auto is_refused = [&](std::vector<std::string> arguments, const std::vector<std::string>& words) {
    return is_input_error(render("out", std::move(arguments)), words);
  };
  EXPECT_TRUE(
      is_refused({"--buffers", "normal", "--format", "svg"}, {"normal", "not made of lines", "strokes"}));
  EXPECT_TRUE(is_refused({"--buffers", "strokes", "--regions"}, {"--regions", "--format png", "svg"}));
  EXPECT_TRUE(is_refused({"--buffers", "strokes", "--format", "svg", "--plot-width", "100"},
                         {"--plot-width", "--centre-lines"}));
  EXPECT_TRUE(is_refused({"--buffers", "strokes", "--format", "svg", "--regions", "--centre-lines"},
                         {"--regions", "pen"}));
  EXPECT_TRUE(is_refused({"--buffers", "reference", "--format", "svg", "--centre-lines"},
                         {"--centre-lines", "reference", "curves"}));
  EXPECT_FALSE(fs::exists(file("out")));
}

}  // namespace
}  // namespace inkbench
