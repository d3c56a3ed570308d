// SPDX-License-Identifier: MIT
// Specs that are wrong: refused whole, before the first cell, with the line and what would be right.
#include <nlohmann/json.hpp>

#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

class StudySpecErrors : public StudyTest {
 protected:
  /// `body` begins on line 3 of the spec.
  void expect_refused(const std::string& body, std::vector<std::string> words) const {
    write_spec("bad", body);
    words.emplace_back("bad.toml");
    EXPECT_TRUE(is_input_error(study("bad", "out"), words)) << body;
    EXPECT_FALSE(fs::exists(file("out"))) << body;
  }
};

TEST_F(StudySpecErrors, missing_scene_is_named_with_its_line) {
  write("bad.toml", "title = \"x\"\nscene = \"lost.toml\"\n");
  EXPECT_TRUE(is_input_error(study("bad", "out"), {"bad.toml:2", "lost.toml", "not found"}));
}

TEST_F(StudySpecErrors, broken_scene_is_named_with_its_line) {
  write("scene.toml", "[camera]\nfov = 900\n");
  write("s.toml", "scene = \"scene.toml\"\n");
  EXPECT_TRUE(is_input_error(study("s", "out"), {"scene.toml:2", "camera.fov = 900"}));
}

TEST_F(StudySpecErrors, unknown_entry_suggests_the_nearest) {
  expect_refused("shwo = [\"final\"]\n", {":3", "shwo", "did you mean 'show'?"});
  expect_refused("[[axis]]\nkey = \"combine.k_depth\"\nvalue = [1]\n", {":5", "value", "'values'"});
  expect_refused("[[variant]]\nnam = \"x\"\n", {":4", "nam", "'name'"});
}

TEST_F(StudySpecErrors, unknown_parameter_suggests_the_nearest) {
  expect_refused("[set]\ncombine.k_dept = 0.1\n", {":4", "combine.k_dept", "'combine.k_depth'"});
  expect_refused("[[axis]]\nkey = \"combine.k_dept\"\nvalues = [1]\n",
                 {":4", "combine.k_dept", "'combine.k_depth'"});
  expect_refused("[[variant]]\nname = \"x\"\n[variant.set]\ncamera.eye.w = 1\n", {":6", "camera.eye"});
}

TEST_F(StudySpecErrors, value_that_the_parameter_refuses_is_refused_beforehand) {
  expect_refused("[[axis]]\nkey = \"combine.k_depth\"\nvalues = [0.1,\n  7]\n",
                 {":6", "combine.k_depth = 7", "1e-06"});
  expect_refused("[[axis]]\nkey = \"combine.k_depth\"\nvalues = [\"x\"]\n",
                 {":5", "combine.k_depth", "number"});
  expect_refused("[[axis]]\nkey = \"camera.fov\"\nfrom = 100\nto = 200\ncount = 3\n",
                 {":3", "camera.fov = 200", "170"});
  expect_refused("[[variant]]\nname = \"x\"\n[variant.set]\ncamera.fov = 900\n", {":6", "camera.fov = 900"});
  expect_refused("size = [0, 10]\n", {":3", "image.width = 0"});
}

TEST_F(StudySpecErrors, axis_without_values_is_refused) {
  expect_refused("[[axis]]\nkey = \"combine.k_depth\"\n", {":3", "values"});
  expect_refused("[[axis]]\nkey = \"combine.k_depth\"\nvalues = []\n",
                 {":5", "combine.k_depth", "no values"});
  expect_refused("[[axis]]\nkey = \"combine.k_depth\"\nfrom = 0.1\nto = 0.2\n", {":3", "count"});
  expect_refused("[[axis]]\nkey = \"combine.k_depth\"\nfrom = 0.1\nto = 0.2\ncount = 0\n",
                 {":7", "count = 0"});
  expect_refused("[[axis]]\nvalues = [1]\n", {":3", "key"});
}

TEST_F(StudySpecErrors, empty_grid_is_refused) {
  expect_refused("axis = []\n", {":3", "empty", "axes"});
  expect_refused("variant = []\n", {":3", "empty", "variants"});
  expect_refused("show = []\n", {":3", "names no buffer", "final"});
}

TEST_F(StudySpecErrors, contradictory_axes_are_refused) {
  const std::string fov = "[[axis]]\nkey = \"camera.fov\"\nvalues = [30, 40]\n";
  expect_refused(fov + fov, {":7", "camera.fov", "second axis"});
  expect_refused(fov + "[[variant]]\nname = \"x\"\nset = { camera.fov = 20 }\n",
                 {":6", "variant sets camera.fov"});
  expect_refused("[[axis]]\nkey = \"camera.fov\"\nvalues = [30]\nfrom = 3\n", {":6", "values and from"});
  expect_refused("[[axis]]\nkey = \"combine.threshold\"\nfrom = 0\nto = 1\ncount = 3\nscale = \"log\"\n",
                 {":3", "log", "above 0"});
  expect_refused("[[axis]]\nkey = \"combine.threshold\"\nfrom = 1\nto = 2\ncount = 3\nscale = \"cubic\"\n",
                 {":8", "cubic", "linear, log"});
  std::string four;
  for (const char* key : {"camera.fov", "camera.near", "camera.far", "combine.threshold"}) {
    four += "[[axis]]\nkey = \"" + std::string(key) + "\"\nvalues = [1]\n";
  }
  expect_refused(four, {"4 axes", "three"});
  expect_refused("[[variant]]\nname = \"x\"\n[[variant]]\nname = \"x\"\n", {":6", "\"x\""});
}

TEST_F(StudySpecErrors, cell_whose_settings_contradict_each_other_is_named_before_any_is_drawn) {
  expect_refused("[[axis]]\nkey = \"camera.eye\"\nvalues = [[0, 1, 8], [0, 1, 0]]\n",
                 {"cell eye = 0, 1, 0", "camera.eye"});
  expect_refused(
      "[[axis]]\nkey = \"model.box.shape\"\nvalues = [\"box\", \"mesh\"]\n[set]\nmodel.box.mesh = "
      "\"lost.obj\"\n",
      {"cell shape = mesh", "lost.obj"});
}

TEST_F(StudySpecErrors, wrong_types_say_which_is_right) {
  expect_refused("show = \"final\"\n", {":3", "show", "list"});
  expect_refused("show = [\"finale\"]\n", {":3", "finale", "'final'"});
  expect_refused("size = 512\n", {":3", "size", "[width, height]"});
  expect_refused("set = 3\n", {":3", "set", "table"});
  expect_refused("purpose = 3\n", {":3", "purpose", "text"});
  expect_refused("[axis]\nkey = \"camera.fov\"\n", {":3", "axis", "[[axis]]"});
}

TEST_F(StudySpecErrors, broken_toml_says_the_line) {
  expect_refused("show = [\n", {":"});
  expect_refused("show = [\"final\"]\nshow = [\"depth\"]\n", {":4", "show"});
}

TEST_F(StudySpecErrors, too_many_cells_for_any_disk_are_refused) {
  const std::string body =
      "[[axis]]\nkey = \"combine.k_depth\"\nfrom = 0.001\nto = 0.9\ncount = 100000\n"
      "[[axis]]\nkey = \"combine.k_normal\"\nfrom = 0.001\nto = 0.9\ncount = 100000\n";
  expect_refused(body, {"10000000000 cells", "10,000,000"});
}

TEST_F(StudySpecErrors, missing_spec_points_to_the_list) {
  EXPECT_TRUE(is_input_error(inkbench({"study", "lost.toml"}), {"lost.toml", "study list"}));
}

TEST_F(StudySpecErrors, measures_become_columns_that_a_score_agrees_with) {
  write_spec("m",
             "show = [\"combined_edges\", \"reference\"]\n"
             "measure = [\"f1\", \"components\", \"recall_silhouette\", \"empty\"]\n");
  ASSERT_TRUE(succeeds(study("m", "out")));
  const StudyTable data = table("out");
  ASSERT_EQ(data.rows.size(), 1U);
  const std::vector<std::string> expected{"cell",
                                          "ink",
                                          "ink_px",
                                          "f1",
                                          "components",
                                          "recall_silhouette",
                                          "empty",
                                          "error",
                                          "FILE_combined_edges",
                                          "FILE_reference"};
  EXPECT_EQ(data.columns, expected);
  EXPECT_EQ(data.rows[0].at("empty"), "false");
  EXPECT_GT(std::stod(data.rows[0].at("f1")), 0.0);
  const double recall = std::stod(data.rows[0].at("recall_silhouette"));
  EXPECT_TRUE(recall > 0.0 && recall <= 1.0) << recall;
  // Measures of the drawing alone do not depend on what it is compared with.
  const std::string drawn = "out/" + data.rows[0].at("FILE_combined_edges");
  const CommandResult score = inkbench({"score", drawn, drawn, "--json"});
  ASSERT_TRUE(succeeds(score));
  EXPECT_EQ(nlohmann::json::parse(score.out).at("components"), std::stoi(data.rows[0].at("components")));
}

TEST_F(StudySpecErrors, unknown_measures_are_named) {
  expect_refused("measure = [\"f2\"]\n", {":3", "f2", "f1"});
  expect_refused("measure = [\"f1_detector\"]\n", {":3", "f1_detector", "write \"f1\""});
  expect_refused("measure = 3\n", {":3", "measure", "true"});
  expect_refused("measure = [\"marks\"]\n", {":3", "'marks'", "inkbench tune"});
}

}  // namespace
}  // namespace inkbench
