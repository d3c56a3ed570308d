// SPDX-License-Identifier: MIT
// A study's charts: what stands in its folder afterwards, that scripts run again, and that no chart costs the
// study.
#include <nlohmann/json.hpp>

#include <algorithm>

#include "pipeline/image/image_file.h"
#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class StudyCharts : public StudyTest {
 protected:
  StudyCharts() {
    write_spec("s", "measure = [\"f1\"]\n" + threshold_axis(3) +
                        "[[axis]]\nkey = \"combine.k_depth\"\nvalues = [0.001, 0.01]\n"
                        "[[chart]]\nname = \"lines\"\ntitle = \"It's <f1> & `more`\"\nx = "
                        "\"combine.k_normal\"\ny = \"f1\"\n"
                        "by = \"combine.k_depth\"\n"
                        "[[chart]]\nname = \"heat\"\nkind = \"heatmap\"\nx = \"combine.k_normal\"\ny = "
                        "\"combine.k_depth\"\n"
                        "value = \"ink_px\"\n");
  }
  CommandResult gnuplot(const std::string& script, const std::string& folder) const {
    CommandOptions options;
    options.working_folder = file(folder);
    return run_command({"/usr/bin/gnuplot", "-d", script}, options);
  }
};

TEST_F(StudyCharts, stand_beside_the_grid_as_script_svg_and_png) {
  const CommandResult result = study("s", "out");
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, AllOf(HasSubstr("out/charts/lines.png\n"), HasSubstr("out/charts/heat.png\n")));
  for (const std::string name : {"lines", "heat"}) {
    const Picture png = read_picture(file("out/charts/" + name + ".png"), 3);
    EXPECT_EQ(png.width_px, 1200);
    EXPECT_EQ(png.height_px, 800);
    EXPECT_GT(std::count_if(png.samples.begin(), png.samples.end(), [](uint8_t v) { return v < 100; }), 3000)
        << name << " is drawn upon";
    const std::string svg = content_of(file("out/charts/" + name + ".svg"));
    EXPECT_THAT(svg, AllOf(HasSubstr("id='chart-" + name + "-"), Not(HasSubstr("id='gp"))));
  }
  EXPECT_THAT(content_of(file("out/charts/lines.svg")),
              HasSubstr("<title>It's &lt;f1&gt; &amp; `more`</title>"));
  EXPECT_EQ(folder_content(file("out/charts")).size(), 6U);
  const auto manifest = nlohmann::json::parse(content_of(file("out/manifest.json")));
  EXPECT_THAT(manifest.at("charts"), ElementsAre("lines", "heat"));
}

TEST_F(StudyCharts, are_the_same_after_a_further_run) {
  ASSERT_TRUE(succeeds(study("s", "out")));
  const FolderContent first = lasting_content(file("out"));
  ASSERT_TRUE(succeeds(study("s", "out")));
  EXPECT_EQ(difference(first, lasting_content(file("out"))), "same");
}

TEST_F(StudyCharts, scripts_run_again_from_any_folder) {
  ASSERT_TRUE(succeeds(study("s", "out")));
  const FolderContent first = folder_content(file("out/charts"));
  for (const auto& [script, folder] :
       {std::pair{"lines.gp", "out/charts"}, std::pair{"charts/lines.gp", "out"},
        std::pair{"out/charts/lines.gp", "."}}) {
    fs::remove(file("out/charts/lines.png"));
    const CommandResult result = gnuplot(script, folder);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(content_of(file("out/charts/lines.png")), first.at("lines.png"));
  }
  EXPECT_EQ(folder_content(file("out/charts")).size(), first.size()) << "and leave nothing elsewhere";
  EXPECT_FALSE(fs::exists(file("lines.svg")));
}

TEST_F(StudyCharts, without_gnuplot_the_study_stays_and_the_script_too) {
  CommandOptions options;
  options.environment["PATH"] = file("nowhere").string();
  const CommandResult result = study("s", "out", {}, options);
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(
      result.err,
      HasSubstr("inkbench: error: chart lines: gnuplot: was not found; install the package gnuplot-nox"));
  EXPECT_THAT(result.err, Not(HasSubstr("cells failed")));
  EXPECT_THAT(result.out, HasSubstr("out/grid.png\n"));
  EXPECT_EQ(table("out").rows.size(), 6U);
  EXPECT_TRUE(fs::exists(file("out/charts/lines.gp")));
  EXPECT_FALSE(fs::exists(file("out/charts/lines.png")));
  ASSERT_TRUE(succeeds(study("s", "out")));
  EXPECT_TRUE(fs::exists(file("out/charts/lines.png"))) << "the next run draws it";
}

TEST_F(StudyCharts, a_failed_chart_leaves_no_picture_of_an_earlier_run) {
  ASSERT_TRUE(succeeds(study("s", "out")));
  CommandOptions options;
  options.environment["PATH"] = file("nowhere").string();
  EXPECT_EQ(study("s", "out", {}, options).status, 1);
  EXPECT_FALSE(fs::exists(file("out/charts/lines.svg")));
  EXPECT_FALSE(fs::exists(file("out/charts/heat.png")));
}

TEST_F(StudyCharts, failed_cells_are_left_out) {
  write("broken.off", "this is no mesh");
  write("scene.toml",
        small_scene() + "[[model]]\nname = \"thing\"\nmesh = \"rabbit\"\nsize = 1\nvisible = false\n");
  write_spec(
      "f",
      "[[variant]]\nname = \"good\"\n[[variant]]\nname = \"bad "
      "\\\"one\\\"\"\n[variant.set]\nmodel.thing.mesh = "
      "\"broken.off\"\nmodel.thing.visible = true\n[[chart]]\nname = \"c\"\nx = \"variant\"\ny = \"ink\"\n");
  const CommandResult result = study("f", "out");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("1 of 2 cells failed"));
  const std::string svg = content_of(file("out/charts/c.svg"));
  EXPECT_THAT(svg, AllOf(HasSubstr("<text>good</text>"), Not(HasSubstr("bad"))));
}

TEST_F(StudyCharts, a_chart_that_cannot_be_is_told_before_the_first_cell) {
  write_spec("bad", threshold_axis(2) + "[[chart]]\nx = \"combine.k_normal\"\ny = \"f1\"\n");
  EXPECT_TRUE(is_input_error(study("bad", "out"), {"bad.toml:10: ", "no column 'f1'", "measure"}));
  EXPECT_FALSE(fs::exists(file("out")));
}

}  // namespace
}  // namespace inkbench
