// SPDX-License-Identifier: MIT
// `inkbench study`: what it leaves, and that each cell is base plus overrides.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

#include "pipeline/image/image_file.h"
#include "tests/cli/study_fixture.h"
#include "tests/places.h"

namespace inkbench {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;

class Study : public StudyTest {};

TEST_F(Study, leaves_report_grid_cells_table_and_manifest) {
  write_spec("s", threshold_axis(3));
  const CommandResult result = study("s", "out");
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, HasSubstr("A small study: 3 cells of 64 x 48 px, at most "));
  EXPECT_THAT(result.out, HasSubstr("out/grid.png\n"));
  for (const char* name : {"index.html", "grid.png", "data.csv", "manifest.json", "cells/0001_final.png",
                           "cells/0002_final.png", "cells/0003_final.png"}) {
    EXPECT_TRUE(fs::exists(file("out") / name)) << name;
  }
  EXPECT_EQ(folder_content(file("out")).size(), 11U)
      << "and the journal and a tile of each picture; no reference lines, which nothing asks for";
  const Picture grid = read_picture(file("out/grid.png"), 3);
  EXPECT_GT(grid.width_px, 3 * 64);
  EXPECT_GT(grid.height_px, 48);
}

TEST_F(Study, of_one_cell_has_a_grid_of_its_views_by_its_buffers) {
  write_spec("s",
             "show = [\"final\", \"depth\", \"normal\"]\n"
             "[[view]]\nname = \"front\"\n[[view]]\nname = \"side\"\n[view.set]\ncamera.eye.x = 9\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  const Picture grid = read_picture(file("out/grid.png"), 3);
  EXPECT_GT(grid.width_px, 3 * 64);
  EXPECT_GT(grid.height_px, 2 * 48);
}

TEST_F(Study, progress_for_programs_is_a_json_line_for_each_step) {
  write_spec("s", threshold_axis(3));
  const CommandResult result = study("s", "out", {"--progress", "json"});
  ASSERT_TRUE(succeeds(result));
  std::vector<nlohmann::json> steps;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('{')) steps.push_back(nlohmann::json::parse(line));
  }
  ASSERT_GE(steps.size(), 2U);
  EXPECT_EQ(steps.front().at("done"), 0);
  EXPECT_EQ(steps.front().at("total"), 3);
  EXPECT_EQ(steps.back().at("done"), 3);
  EXPECT_EQ(steps.back().at("drawn"), 3);
  EXPECT_EQ(steps.back().at("failed"), 0);
  EXPECT_GT(steps.back().at("seconds"), 0.0);
  EXPECT_TRUE(is_input_error(study("s", "out", {"--progress", "loud"}), {"--progress", "loud"}));
}

TEST_F(Study, manifest_says_what_was_run_with_what_and_when) {
  write_spec("s", threshold_axis(2));
  ASSERT_TRUE(succeeds(study("s", "out")));
  const nlohmann::json manifest = nlohmann::json::parse(content_of(file("out/manifest.json")));
  EXPECT_EQ(manifest.at("state"), "finished");
  EXPECT_EQ(manifest.at("version"), INKBENCH_VERSION);
  EXPECT_EQ(manifest.at("spec"), content_of(file("s.toml")));
  EXPECT_EQ(manifest.at("cells"), 2);
  EXPECT_THAT(manifest.at("renderer").at("name").get<std::string>(), Not(IsEmpty()));
  EXPECT_THAT(manifest.at("times").at("written").get<std::string>(), HasSubstr("T"));
}

TEST_F(Study, report_names_the_command_and_every_picture) {
  write_spec("it's", "show = [\"final\", \"depth\"]\n" + threshold_axis(2));
  const CommandResult result = study("it's", "out", {"--set", "camera.fov=40"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, HasSubstr("out/index.html\n"));
  const std::string page = content_of(file("out/index.html"));
  EXPECT_THAT(page, HasSubstr("it&#39;\\&#39;&#39;s.toml&#39; --set camera.fov=40<"));
  const size_t begin = page.find('{', page.find("id=\"study\""));
  const nlohmann::json data =
      nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  EXPECT_EQ(data.at("buffers"), nlohmann::json({"final", "depth"}));
  ASSERT_EQ(data.at("cells").size(), 2U);
  const nlohmann::json& cell = data.at("cells").at(1);
  for (size_t i = 0; i < 2; ++i) {
    const nlohmann::json& pattern = data.at("files").at(i);
    const std::string path = pattern.at(0).get<std::string>() + cell.at("files").get<std::string>() +
                             pattern.at(1).get<std::string>();
    EXPECT_TRUE(fs::exists(file("out") / path)) << path;
    EXPECT_GT(cell.at("thumbs").at(i).get<std::string>().size(), 40U);
  }
  EXPECT_EQ(cell.at("row").size(), 5U) << "all of data.csv but the files";
}

TEST_F(Study, table_has_parameters_then_numbers_then_files) {
  write_spec("s", "show = [\"final\", \"depth\"]\n" + threshold_axis(3) +
                      "[[axis]]\nkey = \"camera.eye.x\"\nvalues = [0, 1]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  const StudyTable data = table("out");
  EXPECT_THAT(data.columns, ElementsAre("cell", "combine.k_normal", "camera.eye.x", "ink", "ink_px", "error",
                                        "FILE_final", "FILE_depth"));
  EXPECT_THAT(data.column("cell"), ElementsAre("1", "2", "3", "4", "5", "6"));
  EXPECT_THAT(data.column("camera.eye.x"), ElementsAre("0", "0", "0", "1", "1", "1"));
  EXPECT_THAT(data.column("error"), Each(IsEmpty()));
  for (const auto& row : data.rows) {
    EXPECT_TRUE(fs::exists(file("out") / row.at("FILE_final")));
    EXPECT_TRUE(fs::exists(file("out") / row.at("FILE_depth")));
  }
}

TEST_F(Study, ink_is_the_share_of_pixels_that_are_not_zero_in_combined_edges) {
  write_spec("s", "show = [\"combined_edges\"]\n" + threshold_axis(4));
  ASSERT_TRUE(succeeds(study("s", "out")));
  for (const auto& row : table("out").rows) {
    const Picture edges = read_picture(file("out") / row.at("FILE_combined_edges"), 1);
    const auto inked =
        std::count_if(edges.samples.begin(), edges.samples.end(), [](uint8_t e) { return e > 0; });
    EXPECT_EQ(row.at("ink_px"), std::to_string(inked));
    EXPECT_NEAR(std::stod(row.at("ink")), static_cast<double>(inked) / (64 * 48), 1e-9);
  }
}

TEST_F(Study, axes_step_linearly_logarithmically_or_through_a_list) {
  write_spec("linear",
             "[[axis]]\nkey = \"combine.threshold\"\nfrom = 0.5\nto = 1.5\ncount = 3\nscale = \"linear\"\n");
  write_spec("log",
             "[[axis]]\nkey = \"combine.threshold\"\nfrom = 0.02\nto = 2\ncount = 3\nscale = \"log\"\n");
  write_spec("own", "[[axis]]\nkey = \"combine.k_depth\"\nfrom = 0.0001\nto = 0.01\ncount = 3\n");
  write_spec("values", "[[axis]]\nkey = \"combine.threshold\"\nvalues = [0.75, 0.1, 1]\n");
  write_spec("integer",
             "[[axis]]\nkey = \"model.ball.segments\"\nfrom = 3\nto = 12\ncount = 4\nscale = \"linear\"\n");
  const auto values = [&](const std::string& name, const std::string& key) {
    EXPECT_TRUE(succeeds(study(name, name)));
    return table(name).column(key);
  };
  EXPECT_THAT(values("linear", "combine.threshold"), ElementsAre("0.5", "1", "1.5"));
  EXPECT_THAT(values("log", "combine.threshold"), ElementsAre("0.02", "0.2", "2"));
  EXPECT_THAT(values("own", "combine.k_depth"), ElementsAre("0.0001", "0.001", "0.01"))
      << "the parameter's own scale is log";
  EXPECT_THAT(values("values", "combine.threshold"), ElementsAre("0.75", "0.1", "1"));
  EXPECT_THAT(values("integer", "model.ball.segments"), ElementsAre("3", "6", "9", "12"));
}

TEST_F(Study, any_parameter_can_be_an_axis) {
  const std::map<std::string, std::string> axes{{"camera.eye", "[[0, 1, 8], [2, 1, 7]]"},
                                                {"light.key.direction", "[[1, 1, 1], [-1, 1, 1]]"},
                                                {"model.ball.shape", "[\"sphere\", \"torus\"]"},
                                                {"model.ball.visible", "[true, false]"},
                                                {"model.box.material.colour", "[\"#ff0000\", [0, 0, 1]]"},
                                                {"ramp.enabled", "[true, false]"},
                                                {"image.precision", "[\"float\", \"unorm8\"]"}};
  for (const auto& [key, values] : axes) {
    write_spec(key, "show = [\"final\"]\n[[axis]]\nkey = \"" + key + "\"\nvalues = " + values + "\n");
    ASSERT_TRUE(succeeds(study(key, key))) << key;
    const bool same = read_picture(file(key) / "cells/0001_final.png", 3) ==
                      read_picture(file(key) / "cells/0002_final.png", 3);
    EXPECT_FALSE(same) << key;
  }
  EXPECT_THAT(table("camera.eye").column("camera.eye"), ElementsAre("[0, 1, 8]", "[2, 1, 7]"));
  EXPECT_THAT(table("model.ball.shape").column("model.ball.shape"), ElementsAre("sphere", "torus"));
}

TEST_F(Study, variants_are_rows_with_names_and_every_key_they_set) {
  write_spec("s",
             "[[variant]]\nname = \"plain\"\n[[variant]]\nname = \"few, \\\"thin\\\" "
             "lines\"\n[variant.set]\ncombine.k_normal = 0.4\n"
             "[[variant]]\nname = \"from afar\"\n[variant.set]\ncamera.eye = [0, 1, 12]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  const StudyTable data = table("out");
  EXPECT_THAT(data.columns, ElementsAre("cell", "variant", "combine.k_normal", "camera.eye", "ink", "ink_px",
                                        "error", "FILE_final"));
  EXPECT_THAT(data.column("variant"), ElementsAre("plain", "few, \"thin\" lines", "from afar"));
  EXPECT_THAT(data.column("combine.k_normal"), ElementsAre("0.0125", "0.4", "0.0125"));
  EXPECT_THAT(data.column("camera.eye"), ElementsAre("[0, 1, 8]", "[0, 1, 8]", "[0, 1, 12]"));
}

TEST_F(Study, third_axis_makes_pages) {
  write_spec("s", threshold_axis(2) +
                      "[[axis]]\nkey = \"camera.eye.x\"\nvalues = [0, 1]\n[[axis]]\nkey = "
                      "\"camera.fov\"\nvalues = [30, 40, 50]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  const StudyTable data = table("out");
  EXPECT_EQ(data.rows.size(), 12U);
  EXPECT_THAT(data.column("camera.fov"),
              ElementsAre("30", "30", "30", "30", "40", "40", "40", "40", "50", "50", "50", "50"));
  for (const char* name : {"grid.png", "grid_2.png", "grid_3.png"})
    EXPECT_TRUE(fs::exists(file("out") / name)) << name;
  EXPECT_FALSE(fs::exists(file("out/grid_4.png")));
}

TEST_F(Study, study_without_axes_is_one_cell) {
  write_spec("s", "size = [20, 10]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  EXPECT_EQ(table("out").rows.size(), 1U);
  EXPECT_EQ(read_picture(file("out/cells/0001_final.png"), 3).width_px, 20);
}

TEST_F(Study, cell_is_base_plus_overrides_whatever_ran_before) {
  // The costly axis (mesh, camera) is the inner one of the grid, so that cells run in another order than they
  // are numbered.
  write_spec("s",
             "size = [40, 30]\n[set]\ncombine.k_normal = 0.02\ncamera.target = [0.1, 1, 0]\n[[axis]]\nkey = "
             "\"model.ball.segments\"\n"
             "values = [5, 20]\n[[axis]]\nkey = \"combine.k_depth\"\nvalues = [0.0005, 0.05]\n[[axis]]\nkey "
             "= \"camera.eye.x\"\nvalues = [0, 3]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  for (const auto& row : table("out").rows) {
    std::vector<std::string> arguments{"render", "--scene", "scene.toml", "--size",
                                       "40x30",  "--out",   "single"};
    for (const std::string& assignment :
         {std::string("combine.k_normal=0.02"), std::string("camera.target=[0.1, 1, 0]"),
          "model.ball.segments=" + row.at("model.ball.segments"),
          "combine.k_depth=" + row.at("combine.k_depth"), "camera.eye.x=" + row.at("camera.eye.x")}) {
      arguments.insert(arguments.end(), {"--set", assignment});
    }
    ASSERT_TRUE(succeeds(inkbench(arguments)));
    EXPECT_EQ(content_of(file("single/final.png")), content_of(file("out") / row.at("FILE_final")))
        << "cell " << row.at("cell");
  }
}

TEST_F(Study, cell_is_made_again_from_its_own_picture) {
  write_spec("s", "show = [\"normal_edges\", \"final\"]\n" + threshold_axis(2));
  ASSERT_TRUE(succeeds(study("s", "out")));
  for (const std::string name : {"0002_normal_edges", "0001_final"}) {
    ASSERT_TRUE(succeeds(inkbench({"render", "--from", "out/cells/" + name + ".png", "--out", "again"})));
    EXPECT_EQ(content_of(file("out/cells/" + name + ".png")),
              content_of(file("again/" + name.substr(5) + ".png")));
  }
}

TEST_F(Study, set_changes_the_base_but_not_an_axis) {
  write_spec("s", threshold_axis(2));
  ASSERT_TRUE(succeeds(study("s", "a", {"--set", "image.width=30", "--set", "camera.fov=60"})));
  EXPECT_EQ(read_picture(file("a/cells/0001_final.png"), 3).width_px, 30);
  EXPECT_TRUE(is_input_error(study("s", "b", {"--set", "combine.k_normal=0.1"}),
                             {"--set", "combine.k_normal", "axis", "s.toml"}));
  EXPECT_FALSE(fs::exists(file("b")));
}

TEST_F(Study, dry_run_tells_the_cells_and_writes_nothing) {
  write_spec("s", threshold_axis(3) + "[[axis]]\nkey = \"camera.fov\"\nvalues = [30, 50]\n");
  const FolderContent before = folder_content(file(""));
  CommandOptions no_egl;
  no_egl.environment["__EGL_VENDOR_LIBRARY_DIRS"] = "/nonexistent";
  const CommandResult result = study("s", "out", {"--dry-run"}, no_egl);
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, HasSubstr("6 cells (3 x 2) of 64 x 48 px"));
  EXPECT_THAT(result.out, HasSubstr("k_normal = 0.5, fov = 50"));
  EXPECT_EQ(folder_content(file("")), before);
  EXPECT_FALSE(fs::exists(file("out")));
}

TEST_F(Study, hundred_thousand_cells_are_counted_before_starting) {
  write_spec("s",
             "size = [512, 512]\n[[axis]]\nkey = \"combine.k_depth\"\nfrom = 0.001\nto = 0.01\ncount = 1000\n"
             "[[axis]]\nkey = \"combine.k_normal\"\nfrom = 0.001\nto = 0.01\ncount = 100\n");
  const CommandResult result = study("s", "out", {"--dry-run"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, HasSubstr("100,000 cells (1000 x 100) of 512 x 512 px, at most 7"));
  EXPECT_THAT(result.out, HasSubstr("GB"));
}

TEST_F(Study, list_names_each_bundled_study_with_its_purpose) {
  const CommandResult result = inkbench({"study", "list"});
  ASSERT_TRUE(succeeds(result));
  for (int figure = 1; figure <= 13; ++figure) {
    EXPECT_THAT(result.out, HasSubstr(fmt::format("studies/figures/figure_{:02}.toml  ", figure)));
    EXPECT_THAT(result.out, HasSubstr(fmt::format("Figure {}: ", figure)));
  }
  EXPECT_THAT(result.out, testing::ContainsRegex("studies/k_comparison.toml +[A-Z].{20}"));
  EXPECT_THAT(result.out, testing::ContainsRegex("studies/k_sweep.toml +[A-Z].{20}"));
}

TEST_F(Study, bundled_study_is_found_by_name_from_any_folder) {
  ASSERT_TRUE(succeeds(inkbench({"study", "k_sweep", "--dry-run"})));
  ASSERT_TRUE(succeeds(inkbench({"study", "studies/k_comparison.toml", "--dry-run"})));
  ASSERT_TRUE(succeeds(inkbench({"study", "figure_07", "--dry-run"})));
  EXPECT_TRUE(is_input_error(inkbench({"study", "k_swep"}), {"k_swep", "study list"}));
}

TEST_F(Study, every_bundled_study_is_valid) {
  for (const char* folder : {"studies", "studies/figures"}) {
    EXPECT_TRUE(succeeds(inkbench({"study", fs::path(source_folder()) / folder, "--dry-run"})));
  }
}

TEST_F(Study, folder_of_specs_makes_a_folder_for_each) {
  for (const std::string name : {"one", "two"}) {
    write("specs/" + name + ".toml", "scene = \"../scene.toml\"\ntitle = \"" + name + "\"\n");
  }
  write("specs/notes.txt", "not a spec");
  ASSERT_TRUE(succeeds(inkbench({"study", "specs", "--out", "all"})));
  EXPECT_TRUE(fs::exists(file("all/one/grid.png")));
  EXPECT_TRUE(fs::exists(file("all/two/grid.png")));
  ASSERT_TRUE(succeeds(inkbench({"study", "specs/"})));
  EXPECT_TRUE(fs::exists(file("out/specs/one/grid.png"))) << "out/ and the folder's name without --out";
}

TEST_F(Study, folder_without_specs_is_refused) {
  fs::create_directories(file("empty"));
  EXPECT_TRUE(is_input_error(inkbench({"study", "empty"}), {"empty", ".toml"}));
}

TEST_F(Study, without_out_results_go_to_out_and_the_specs_name) {
  write_spec("small", threshold_axis(1));
  ASSERT_TRUE(succeeds(inkbench({"study", "small.toml"})));
  EXPECT_TRUE(fs::exists(file("out/small/grid.png")));
}

TEST_F(Study, progress_in_a_pipe_is_whole_quiet_lines) {
  write_spec("s", threshold_axis(8));
  const CommandResult result = study("s", "out");
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.err, Not(HasSubstr("\r")));
  EXPECT_THAT(result.err, Not(HasSubstr("\033")));
  EXPECT_THAT(result.err, MatchesRegex("8 / 8 cells, [0-9.]+ a second\n"));
}

TEST_F(Study, same_study_twice_gives_the_same_bytes) {
  write_spec("s", "show = [\"final\", \"combined_edges\"]\n" + threshold_axis(6) +
                      "[[axis]]\nkey = \"camera.eye.x\"\nvalues = [0, 1]\n");
  ASSERT_TRUE(succeeds(study("s", "first")));
  ASSERT_TRUE(succeeds(study("s", "elsewhere/second")));
  EXPECT_EQ(difference(lasting_content(file("first")), lasting_content(file("elsewhere/second"))), "same");
}

}  // namespace
}  // namespace inkbench
