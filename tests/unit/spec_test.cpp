// SPDX-License-Identifier: MIT
// Study specs: what a spec says is which cells there are; what it cannot say is an error with file and line.
#include "studies/sweep/spec.h"
#include "studies/sweep/labels.h"

#include <gmock/gmock.h>

#include <set>

#include "pipeline/base/files.h"
#include "pipeline/settings/settings_file.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

StudySpec parse(const std::string& text, const std::vector<std::string>& assignments = {}) {
  return parse_spec(text, "/studies/s.toml", assignments);
}

std::string parse_error(const std::string& text, const std::vector<std::string>& assignments = {}) {
  return error_of([&] { parse(text, assignments); });
}

/// The message at that line of the spec.
std::string at(int line, const std::string& message) {
  return "/studies/s.toml:" + std::to_string(line) + ": " + message;
}

std::string axis(const std::string& key, const std::string& rest) {
  return "[[axis]]\nkey = \"" + key + "\"\n" + rest + "\n";
}

std::vector<float> reals(const Axis& axis) {
  std::vector<float> numbers;
  for (const Value& value : axis.values) numbers.push_back(std::get<float>(value));
  return numbers;
}

TEST(Spec, an_empty_one_is_the_papers_scene_once) {
  const StudySpec spec = parse("");
  EXPECT_EQ(spec.title, "s");
  EXPECT_EQ(spec.purpose, "");
  EXPECT_THAT(spec.show, ElementsAre(BufferName::final));
  EXPECT_EQ(settings_text(spec.base), settings_text(load_settings(project_file("data/scenes/paper.toml"))));
  ASSERT_EQ(cell_count(spec), 1U);
  EXPECT_EQ(make_cell(spec, 0).name, "");
  EXPECT_TRUE(make_cell(spec, 0).set.empty());
}

TEST(Spec, entries_reach_what_they_name) {
  const StudySpec spec = parse(
      "title = \"T\"\npurpose = \"P\"\nsize = [640, 480]\nshow = [\"depth\", \"final\", \"depth\"]\n"
      "[set]\ncombine.k_depth = 0.5\nmodel.rabbit.position.y = 2\n");
  EXPECT_EQ(spec.title, "T");
  EXPECT_EQ(spec.purpose, "P");
  EXPECT_EQ(spec.base.image.width, 640);
  EXPECT_EQ(spec.base.image.height, 480);
  EXPECT_THAT(spec.show, ElementsAre(BufferName::depth, BufferName::final));
  EXPECT_EQ(spec.base.combine.k_depth, 0.5F);
  EXPECT_EQ(spec.base.models[0].position, glm::vec3(0, 2, 0));
}

TEST(Spec, assignments_go_over_the_specs_own_set) {
  const StudySpec spec = parse("[set]\ncombine.k_depth = 0.5\n", {"combine.k_depth=0.25", "image.width=99"});
  EXPECT_EQ(spec.base.combine.k_depth, 0.25F);
  EXPECT_EQ(spec.base.image.width, 99);
}

TEST(Spec, the_scene_may_lie_beside_the_spec_or_in_the_project) {
  const TemporaryFolder folder;
  folder.write("scenes/one.toml", "combine.k_depth = 0.5\n");
  const auto k_depth = [&](const std::string& scene) {
    return parse_spec("scene = \"" + scene + "\"", folder.path() / "s.toml", {}).base.combine.k_depth;
  };
  EXPECT_EQ(k_depth("scenes/one.toml"), 0.5F);
  EXPECT_EQ(k_depth("data/scenes/paper.toml"), 0.003F);
  folder.write("data/scenes/paper.toml", "combine.k_depth = 0.125\n");
  EXPECT_EQ(k_depth("data/scenes/paper.toml"), 0.125F) << "the spec's own folder comes first";
}

TEST(Spec, a_scene_that_is_not_there_is_an_error) {
  for (const std::string& scene :
       {std::string("none.toml"), std::string(""), std::string("data"), std::string(400, 's')}) {
    EXPECT_THAT(parse_error("\nscene = \"" + scene + "\""),
                StartsWith(at(2, "scene \"" + scene + "\" was not found")));
  }
  EXPECT_EQ(parse_error("scene = 1"), at(1, "scene is a number; it must be text"));
}

TEST(Spec, unknown_entries_are_errors) {
  EXPECT_EQ(parse_error("\ntitel = \"x\"\n"), at(2, "unknown entry 'titel'; did you mean 'title'?"));
  EXPECT_THAT(parse_error(axis("combine.k_depth", "values = [1]\nlable = \"x\"")),
              StartsWith(at(4, "unknown entry 'lable'; did you mean 'label'?")));
  EXPECT_THAT(parse_error("[[variant]]\nname = \"a\"\nsets = {}\n"),
              StartsWith(at(3, "unknown entry 'sets'; did you mean 'set'?")));
  EXPECT_THAT(parse_error("combine.k_depth = 1"), StartsWith(at(1, "unknown entry 'combine'")));
  EXPECT_THAT(parse_error("base = \"x\""), StartsWith(at(1, "unknown entry 'base'")));
}

TEST(Spec, broken_toml_names_file_and_line) {
  EXPECT_THAT(parse_error("title = \"a\"\n[[axis]\n"), StartsWith(at(2, "not valid TOML")));
  EXPECT_THAT(parse_error("title = \"a\"\ntitle = \"b\"\n"), StartsWith(at(2, "not valid TOML")));
}

TEST(Spec, texts_must_be_text) {
  EXPECT_EQ(parse_error("title = 1"), at(1, "title is a number; it must be text"));
  EXPECT_EQ(parse_error("purpose = [1]"), at(1, "purpose is a list of 1; it must be text"));
}

TEST(Spec, size_is_two_whole_numbers) {
  for (const char* size : {"512", "[512]", "[1, 2, 3]", "\"512x512\"", "{}"}) {
    EXPECT_THAT(parse_error(std::string("\nsize = ") + size),
                AllOf(StartsWith(at(2, "size is ")), HasSubstr("it must be [width, height] in px")));
  }
  EXPECT_THAT(parse_error("size = [0, 512]"), StartsWith(at(1, "image.width = 0 is out of range")));
  EXPECT_THAT(parse_error("size = [512, 1e9]"),
              StartsWith(at(1, "image.height = 1000000000 is out of range")));
  EXPECT_THAT(parse_error("size = [512, \"512\"]"), StartsWith(at(1, "image.height is the text \"512\"")));
}

TEST(Spec, show_names_at_least_one_buffer) {
  EXPECT_EQ(parse_error("\nshow = [\"finl\"]"), at(2, "unknown buffer 'finl'; did you mean 'final'?"));
  EXPECT_EQ(parse_error("show = []"), at(1, "names no buffer; for example: final, combined_edges"));
  EXPECT_EQ(parse_error("show = \"final\""),
            at(1, "show is the text \"final\"; it must be a list of buffers: [\"final\"]"));
  EXPECT_EQ(parse_error("show = [1]"), at(1, "show is a number; it must be text"));
  EXPECT_EQ(parse("show = [\"all\"]").show.size(), all_buffers().size());
}

TEST(Spec, set_is_checked_like_a_scene) {
  EXPECT_EQ(parse_error("[set]\ncombine.k_dept = 1\n"),
            at(2, "unknown parameter 'combine.k_dept'; did you mean 'combine.k_depth'?"));
  EXPECT_THAT(parse_error("[set]\ncombine.k_depth = 7\n"),
              StartsWith(at(2, "combine.k_depth = 7 is out of range")));
  EXPECT_EQ(parse_error("set = 1"), at(1, "set is a number; it must be a table: [set]"));
  EXPECT_THAT(parse_error("[set]\nmodel.hare.size = 1\n"),
              StartsWith(at(2, "unknown parameter 'model.hare.size'")));
}

TEST(Spec, bad_assignments_are_errors) {
  EXPECT_THAT(parse_error("", {"combine.k_depth"}), StartsWith("--set combine.k_depth: is not KEY=VALUE"));
  EXPECT_THAT(parse_error("", {"combine.k_dept=1"}), StartsWith("--set combine.k_dept=1: unknown parameter"));
}

TEST(SpecAxis, lists_its_values_as_the_parameters_type) {
  const StudySpec spec =
      parse(axis("combine.k_depth", "values = [1, 0.5, 1e-6]") + axis("image.width", "values = [64, 128.0]") +
            axis("model.rabbit.shape", "values = [\"mesh\", \"box\"]"));
  EXPECT_THAT(reals(spec.axes[0]), ElementsAre(1.0F, 0.5F, 1e-6F));
  EXPECT_THAT(spec.axes[1].values, ElementsAre(Value(64), Value(128)));
  EXPECT_THAT(spec.axes[2].values, ElementsAre(Value(std::string("mesh")), Value(std::string("box"))));
}

TEST(SpecAxis, label_is_the_keys_last_part_unless_given) {
  const StudySpec spec = parse(axis("combine.k_depth", "values = [1]") +
                               axis("combine.k_normal", "values = [1]\nlabel = \"k of n\""));
  EXPECT_EQ(spec.axes[0].label, "k_depth");
  EXPECT_EQ(spec.axes[1].label, "k of n");
}

TEST(SpecAxis, relative_paths_start_from_the_spec) {
  const StudySpec spec = parse(axis("model.rabbit.mesh", "values = [\"rabbit\", \"m/a.obj\"]"));
  EXPECT_THAT(spec.axes[0].values,
              ElementsAre(Value(std::string("rabbit")), Value(std::string("/studies/m/a.obj"))));
}

TEST(SpecAxis, a_linear_range_has_exact_ends_and_even_steps) {
  const std::vector<float> values =
      reals(parse(axis("combine.threshold", "from = 0.1\nto = 0.7\ncount = 7")).axes[0]);
  ASSERT_EQ(values.size(), 7U);
  EXPECT_EQ(values.front(), 0.1F);
  EXPECT_EQ(values.back(), 0.7F);
  for (size_t i = 0; i < 7; ++i) EXPECT_NEAR(values[i], 0.1 * static_cast<double>(i + 1), 1e-7);
}

TEST(SpecAxis, a_log_range_has_exact_ends_and_even_ratios) {
  const std::vector<float> values =
      reals(parse(axis("combine.k_depth", "from = 0.0006\nto = 0.015\ncount = 7")).axes[0]);
  ASSERT_EQ(values.size(), 7U) << "log is this parameter's own scale";
  EXPECT_EQ(values.front(), 0.0006F);
  EXPECT_EQ(values.back(), 0.015F);
  EXPECT_NEAR(values[3], 0.003F, 1e-9F);
  for (size_t i = 1; i < 7; ++i) EXPECT_NEAR(values[i] / values[i - 1], std::pow(25.0, 1.0 / 6.0), 1e-5);
}

TEST(SpecAxis, scale_overrides_the_parameters_own) {
  EXPECT_THAT(
      reals(parse(axis("combine.k_depth", "from = 0.25\nto = 0.75\ncount = 3\nscale = \"linear\"")).axes[0]),
      ElementsAre(0.25F, 0.5F, 0.75F));
  EXPECT_THAT(
      reals(parse(axis("combine.threshold", "from = 0.5\nto = 2\ncount = 3\nscale = \"log\"")).axes[0]),
      ElementsAre(0.5F, 1.0F, 2.0F));
}

TEST(SpecAxis, ranges_may_fall_and_may_be_one_value) {
  EXPECT_THAT(reals(parse(axis("combine.threshold", "from = 1\nto = 0\ncount = 3")).axes[0]),
              ElementsAre(1.0F, 0.5F, 0.0F));
  EXPECT_THAT(reals(parse(axis("combine.threshold", "from = 0.5\nto = 1\ncount = 1")).axes[0]),
              ElementsAre(0.5F));
  EXPECT_THAT(reals(parse(axis("combine.threshold", "from = 0.5\nto = 0.5\ncount = 5")).axes[0]),
              ElementsAre(0.5F));
}

TEST(SpecAxis, whole_numbers_come_once_each) {
  const StudySpec spec = parse(axis("model.box.segments", "from = 1\nto = 8\ncount = 20"));
  EXPECT_THAT(spec.axes[0].values,
              ElementsAre(Value(1), Value(2), Value(3), Value(4), Value(5), Value(6), Value(7), Value(8)));
}

TEST(SpecAxis, a_component_can_be_swept) {
  const StudySpec spec =
      parse(axis("camera.eye.x", "from = 0\nto = 2\ncount = 3") + axis("camera.eye.y", "values = [7]"));
  const Settings settings = cell_settings(spec, make_cell(spec, 2));
  EXPECT_EQ(settings.camera.eye, glm::vec3(2, 7, spec.base.camera.eye.z));
  EXPECT_EQ(make_cell(spec, 2).name, "eye.x = 2, eye.y = 7");
}

TEST(SpecAxis, errors_name_file_and_line) {
  EXPECT_THAT(parse_error("\n[[axis]]\nvalues = [1]"), StartsWith(at(2, "an [[axis]] without a key")));
  EXPECT_THAT(parse_error(axis("combine.k_dept", "values = [1]")),
              StartsWith(at(2, "unknown parameter 'combine.k_dept'")));
  EXPECT_EQ(parse_error("[[axis]]\nkey = 1"), at(2, "key is a number; it must be text"));
  EXPECT_EQ(parse_error(axis("combine.k_depth", "values = [1]\nlabel = 1")),
            at(4, "label is a number; it must be text"));
  EXPECT_EQ(parse_error(axis("combine.k_depth", "")),
            at(1, "the axis has no values and no from; give values, or from, to and count"));
  EXPECT_THAT(parse_error(axis("combine.k_depth", "from = 1\nto = 1")),
              StartsWith(at(1, "the axis has no values and no count")));
  EXPECT_EQ(parse_error(axis("combine.k_depth", "values = []")),
            at(3, "the axis over combine.k_depth has no values; list at least one"));
  EXPECT_EQ(parse_error(axis("combine.k_depth", "values = 1")),
            at(3, "values is a number; it must be a list"));
  EXPECT_THAT(parse_error(axis("combine.k_depth", "values = [\n1,\n7]")),
              StartsWith(at(5, "combine.k_depth = 7 is out of range")));
  EXPECT_THAT(parse_error(axis("combine.k_depth", "values = [\"a\"]")),
              StartsWith(at(3, "combine.k_depth is the text \"a\"")));
  EXPECT_THAT(parse_error(axis("model.rabbit.shape", "values = [\"ball\"]")),
              StartsWith(at(3, "model.rabbit.shape = \"ball\" is not one")));
  EXPECT_THAT(parse_error("axis = 1"), StartsWith(at(1, "axis is a number; it must be tables: [[axis]]")));
  EXPECT_THAT(parse_error("[axis]\nkey = \"combine.k_depth\""),
              StartsWith(at(1, "axis is a table; it must be tables: [[axis]]")));
  EXPECT_EQ(parse_error("axis = []"), at(1, "an empty list of axes"));
}

TEST(SpecAxis, values_and_a_range_exclude_each_other) {
  for (const char* entry : {"from = 1", "to = 1", "count = 1", "scale = \"log\""}) {
    const std::string name(entry, std::string(entry).find(' '));
    EXPECT_EQ(parse_error(axis("combine.k_depth", std::string("values = [1]\n") + entry)),
              at(4, "both values and " + name + "; give values, or from, to and count"));
  }
}

TEST(SpecAxis, counts_are_whole_numbers_within_reason) {
  for (const char* count : {"0", "-1", "1.5", "1000001", "1e300", "9223372036854775807"}) {
    EXPECT_THAT(
        parse_error(axis("combine.k_depth", std::string("from = 0.1\nto = 1\ncount = ") + count)),
        AllOf(StartsWith(at(5, "count = ")), HasSubstr("it must be a whole number from 1 to 1,000,000")));
  }
  EXPECT_THAT(parse_error(axis("combine.k_depth", "from = 0.1\nto = 1\ncount = \"3\"")),
              StartsWith(at(5, "count is the text \"3\"")));
  EXPECT_THAT(parse_error(axis("combine.k_depth", "from = nan\nto = 1\ncount = 3")),
              StartsWith(at(3, "from is a number; it must be a finite number")));
  EXPECT_EQ(parse(axis("combine.k_depth", "from = 0.1\nto = 1\ncount = 3.0")).axes[0].values.size(), 3U);
}

TEST(SpecAxis, a_log_range_is_above_zero) {
  EXPECT_EQ(parse_error(axis("combine.threshold", "from = 0\nto = 1\ncount = 3\nscale = \"log\"")),
            at(1, "a log axis from 0 to 1; both must be above 0"));
  EXPECT_THAT(parse_error(axis("camera.eye.x", "from = 1\nto = -1\ncount = 3\nscale = \"log\"")),
              HasSubstr("both must be above 0"));
  EXPECT_EQ(parse_error(axis("combine.threshold", "from = 0\nto = 1\ncount = 3\nscale = \"cubic\"")),
            at(6, "scale is \"cubic\"; one of: linear, log"));
}

TEST(SpecAxis, a_range_stays_within_the_parameters_limits) {
  EXPECT_THAT(parse_error(axis("combine.k_depth", "from = 0.5\nto = 1.5\ncount = 3")),
              StartsWith(at(1, "combine.k_depth = 1.5 is out of range")));
  EXPECT_THAT(parse_error(axis("image.width", "from = 4294967297\nto = 4294967299\ncount = 3")),
              StartsWith(at(1, "image.width = 4294967300 is out of range")));
  EXPECT_THAT(parse_error(axis("image.width", "from = 1\nto = 1e300\ncount = 3")), HasSubstr("out of range"));
  EXPECT_THAT(parse_error(axis("camera.eye.x", "from = -1e308\nto = 1e308\ncount = 3")),
              HasSubstr("out of range"));
}

TEST(SpecAxis, a_range_needs_a_number) {
  for (const char* key : {"combine.use_depth", "model.rabbit.shape", "model.rabbit.mesh", "camera.eye",
                          "ink.colour", "ramp.diffuse"}) {
    EXPECT_THAT(parse_error(axis(key, "from = 0\nto = 1\ncount = 2")),
                AllOf(StartsWith(at(1, "from and to need a number")), HasSubstr("give values instead")));
  }
}

TEST(SpecAxis, three_at_most_and_each_over_its_own_parameter) {
  const std::string four = axis("combine.k_depth", "values = [1]") +
                           axis("combine.k_normal", "values = [1]") +
                           axis("combine.threshold", "values = [1]") + axis("image.width", "values = [1]");
  EXPECT_EQ(parse_error(four), "/studies/s.toml: has 4 axes; at most three: columns, rows, pages");
  EXPECT_EQ(parse_error(axis("combine.k_depth", "values = [1]") + axis("combine.k_depth", "values = [1]")),
            at(5, "a second axis over combine.k_depth; each axis needs another key"));
  EXPECT_THAT(parse_error(axis("camera.eye.x", "values = [1]") + axis("camera.eye.r", "values = [1]")),
              StartsWith(at(5, "a second axis over camera.eye.x")));
  EXPECT_THAT(parse_error(axis("camera.eye", "values = [1]") + axis("camera.eye.x", "values = [1]")),
              StartsWith(at(5, "a second axis over camera.eye")));
}

TEST(SpecAxis, what_it_varies_cannot_be_set_from_outside) {
  const std::string text = axis("combine.k_depth", "values = [1]");
  EXPECT_EQ(parse_error(text, {"combine.k_depth=0.5"}),
            "--set combine.k_depth=0.5: is what the study's axis varies; edit the axis in /studies/s.toml");
  EXPECT_THAT(parse_error(text, {" combine.k_depth = 0.5"}), HasSubstr("is what the study's axis varies"));
  EXPECT_NO_THROW(parse(text, {"combine.k_normal=0.5"}));
  EXPECT_THAT(parse_error(axis("camera.eye.x", "values = [1]"), {"camera.eye.r=2"}),
              HasSubstr("is what the study's axis varies"));
  EXPECT_THAT(parse_error(axis("camera.eye", "values = [1]"), {"camera.eye.x=2"}),
              HasSubstr("is what the study's axis varies"));
  const StudySpec spec = parse(axis("camera.eye.x", "values = [1]"), {"camera.eye=[7, 8, 9]"});
  EXPECT_EQ(cell_settings(spec, make_cell(spec, 0)).camera.eye, glm::vec3(1, 8, 9));
}

TEST(SpecVariant, cells_are_the_base_and_what_the_variant_sets) {
  const StudySpec spec = parse(
      "[set]\ncombine.threshold = 1\n"
      "[[variant]]\nname = \"plain\"\n"
      "[[variant]]\nname = \"fine\"\n[variant.set]\ncombine.k_depth = 0.25\nmodel.rabbit.material.specular = "
      "0.5\n"
      "[[variant]]\nname = \"moved\"\nset = {camera.eye.x = 9, model.rabbit = {position = 2}}\n");
  ASSERT_EQ(cell_count(spec), 3U);
  EXPECT_EQ(settings_text(cell_settings(spec, make_cell(spec, 0))), settings_text(spec.base));
  const Cell fine = make_cell(spec, 1);
  EXPECT_EQ(fine.name, "fine");
  EXPECT_EQ(fine.index, 1U);
  EXPECT_EQ(fine.column, 1);
  EXPECT_EQ(fine.row, 0);
  Settings expected = spec.base;
  expected.combine.k_depth = 0.25F;
  expected.models[0].material.specular = 0.5F;
  EXPECT_EQ(settings_text(cell_settings(spec, fine)), settings_text(expected));
  const Settings moved = cell_settings(spec, make_cell(spec, 2));
  EXPECT_EQ(moved.camera.eye, glm::vec3(9, spec.base.camera.eye.y, spec.base.camera.eye.z));
  EXPECT_EQ(moved.models[0].position, glm::vec3(2));
}

TEST(SpecVariant, errors_name_file_and_line) {
  EXPECT_THAT(parse_error("\n[[variant]]\n"), StartsWith(at(2, "a [[variant]] without a name")));
  EXPECT_EQ(parse_error("[[variant]]\nname = 1"), at(2, "name is a number; it must be text"));
  EXPECT_EQ(parse_error("[[variant]]\nname = \"a\"\n[[variant]]\nname = \"a\""),
            at(4, "a second variant is named \"a\"; names must differ"));
  EXPECT_EQ(parse_error("[[variant]]\nname = \"a\"\nset = 1"),
            at(3, "set is a number; it must be a table: [variant.set]"));
  EXPECT_EQ(parse_error("[[variant]]\nname = \"a\"\nset = [1]"),
            at(3, "set is a list of 1; it must be a table: [variant.set]"));
  EXPECT_THAT(parse_error("[[variant]]\nname = \"a\"\n[variant.set]\ncombine.k_dept = 1"),
              StartsWith(at(4, "unknown parameter 'combine.k_dept'")));
  EXPECT_THAT(parse_error("[[variant]]\nname = \"a\"\n[variant.set]\ncombine.k_depth = 7"),
              StartsWith(at(4, "combine.k_depth = 7 is out of range")));
  EXPECT_THAT(parse_error("[[variant]]\nname = \"a\"\n[variant.set]\ncombine.use_depth = 7"),
              StartsWith(at(4, "combine.use_depth is a number")));
  EXPECT_THAT(parse_error("[[variant]]\nname = \"a\"\n[variant.set]\ncombin = {}"),
              StartsWith(at(4, "unknown parameter 'combin'")));
  EXPECT_THAT(parse_error("variant = \"a\""),
              StartsWith(at(1, "variant is the text \"a\"; it must be tables: [[variant]]")));
  EXPECT_EQ(parse_error("variant = []"), at(1, "an empty list of variants"));
}

TEST(SpecVariant, beside_axes_they_are_the_next_side_of_the_grid) {
  const StudySpec spec = parse_spec(axis("combine.k_depth", "values = [0.25, 0.5]") +
                                        "[[variant]]\nname = \"plain\"\n"
                                        "[[variant]]\nname = \"thick\"\n[variant.set]\nink.colour.r = 0.5\n",
                                    "s.toml", {});
  ASSERT_EQ(cell_count(spec), 4U);
  const Cell cell = make_cell(spec, 3);
  EXPECT_EQ(cell.column, 1);
  EXPECT_EQ(cell.row, 1);
  EXPECT_EQ(cell.variant, "thick");
  EXPECT_EQ(cell.name, "thick, k_depth = 0.5");
  const Settings settings = cell_settings(spec, cell);
  EXPECT_EQ(settings.combine.k_depth, 0.5F);
  EXPECT_EQ(settings.ink.colour.x, 0.5F);
  EXPECT_EQ(make_cell(spec, 1).variant, "plain");
}

TEST(SpecVariant, may_not_set_what_an_axis_varies_nor_stand_beside_three_axes) {
  const std::string k = axis("combine.k_depth", "values = [1]");
  EXPECT_EQ(parse_error(k + "[[variant]]\nname = \"a\"\nset = { combine.k_depth = 0.5 }"),
            at(4, "a variant sets combine.k_depth, which an axis varies; let one of them set it"));
  EXPECT_EQ(parse_error(k + axis("combine.k_normal", "values = [1]") +
                        axis("combine.threshold", "values = [1]") + "[[variant]]\nname = \"a\"\n"),
            at(10,
               "three [[axis]] and [[variant]]; columns, rows and pages are all taken: at most two axes "
               "beside variants"));
}

TEST(SpecView, is_a_part_of_every_cell) {
  const StudySpec spec = parse_spec(axis("combine.k_depth", "values = [0.25, 0.5]") +
                                        "[[view]]\nname = \"front\"\n"
                                        "[[view]]\nname = \"far-2\"\n[view.set]\ncamera.fov = 60\n",
                                    "s.toml", {});
  EXPECT_EQ(cell_count(spec), 2U);
  EXPECT_EQ(view_count(spec), 2U);
  const Cell cell = make_cell(spec, 1);
  EXPECT_EQ(view_settings(spec, cell, 0).camera.fov, spec.base.camera.fov);
  const Settings far = view_settings(spec, cell, 1);
  EXPECT_EQ(far.camera.fov, 60.0F);
  EXPECT_EQ(far.combine.k_depth, 0.5F);
  EXPECT_EQ(view_count(parse_spec("", "s.toml", {})), 1U);
}

TEST(SpecView, errors_name_file_and_line) {
  EXPECT_THAT(parse_error("\n[[view]]\n"), StartsWith(at(2, "a [[view]] without a name")));
  EXPECT_EQ(parse_error("view = []"), at(1, "an empty list of views"));
  EXPECT_EQ(parse_error("[[view]]\nname = \"../a\"\n"),
            at(1, "a view is named \"../a\"; its files bear its name: use 1 to 40 of a-z, 0-9, - and _"));
  EXPECT_EQ(parse_error(axis("camera.eye", "values = [[1, 2, 3]]") +
                        "[[view]]\nname = \"a\"\nset = { camera.eye.x = 0.5 }"),
            at(4, "a view sets camera.eye.x, which an axis varies; let one of them set it"));
  EXPECT_EQ(parse_error("[[variant]]\nname = \"v\"\nset = { camera.fov = 20 }\n"
                        "[[view]]\nname = \"a\"\nset = { camera.fov = 50 }"),
            at(4, "a view sets camera.fov, and so does variant \"v\"; let one of them set it"));
  EXPECT_THAT(error_of([] {
                parse_spec("[[view]]\nname = \"a\"\nset = { camera.fov = 50 }", "s.toml", {"camera.fov=20"});
              }),
              StartsWith("--set camera.fov=20: is what the study's views set"));
}

TEST(SpecView, whose_settings_contradict_each_other_is_named) {
  const StudySpec spec = parse_spec(
      "[[view]]\nname = \"front\"\n[[view]]\nname = \"bad\"\nset = { camera.near = 30 }", "s.toml", {});
  EXPECT_THAT(error_of([&] { check_cells(spec); }), StartsWith("s.toml, view bad: "));
}

TEST(SpecCells, columns_run_fastest_then_rows_then_pages) {
  const StudySpec spec = parse(axis("combine.k_depth", "values = [0.1, 0.2]") +
                               axis("combine.k_normal", "values = [0.3, 0.4, 0.5]") +
                               axis("model.rabbit.shape", "values = [\"mesh\", \"box\"]"));
  ASSERT_EQ(cell_count(spec), 12U);
  std::set<std::string> names;
  for (size_t i = 0; i < 12; ++i) {
    const Cell cell = make_cell(spec, i);
    EXPECT_EQ(cell.index, i);
    EXPECT_EQ(static_cast<size_t>(cell.column + 2 * cell.row + 6 * cell.page), i);
    EXPECT_LT(cell.column, 2);
    EXPECT_LT(cell.row, 3);
    names.insert(cell.name);
    const Settings settings = cell_settings(spec, cell);
    EXPECT_EQ(settings.combine.k_depth, cell.column == 0 ? 0.1F : 0.2F);
    EXPECT_EQ(settings.combine.k_normal, 0.3F + 0.1F * static_cast<float>(cell.row));
    EXPECT_EQ(settings.models[0].shape, cell.page == 0 ? Shape::mesh : Shape::box);
  }
  EXPECT_EQ(names.size(), 12U);
  EXPECT_EQ(make_cell(spec, 1).name, "k_depth = 0.2, k_normal = 0.3, shape = mesh");
  EXPECT_EQ(make_cell(spec, 11).name, "k_depth = 0.2, k_normal = 0.5, shape = box");
}

TEST(SpecCells, differ_from_the_base_only_in_what_they_set) {
  const StudySpec spec = parse(axis("combine.k_depth", "values = [0.1, 0.2]"));
  Settings expected = spec.base;
  expected.combine.k_depth = 0.2F;
  EXPECT_EQ(settings_text(cell_settings(spec, make_cell(spec, 1))), settings_text(expected));
}

TEST(SpecCells, labels_are_short) {
  EXPECT_EQ(label_text(Value(0.0123456F)), "0.01235");
  EXPECT_EQ(label_text(Value(7)), "7");
  EXPECT_EQ(label_text(Value(true)), "true");
  EXPECT_EQ(label_text(Value(std::string("/meshes/hare.obj"))), "hare.obj");
  EXPECT_EQ(label_text(Value(std::string("box"))), "box");
  EXPECT_EQ(label_text(Value(glm::vec3(1, 0.5F, 0))), "1, 0.5, 0");
  EXPECT_EQ(label_text(Value(Ramp{{{}, {}}, ""})), "2 stops");
  EXPECT_EQ(label_text(Value(Ramp{{}, "/r/a.png"})), "a.png");
}

TEST(SpecCells, a_hundred_thousand_are_checked) {
  const StudySpec spec = parse("[set]\nmodel.rabbit.shape = \"box\"\n" +
                               axis("combine.k_depth", "from = 0.001\nto = 1\ncount = 400") +
                               axis("combine.k_normal", "from = 0.001\nto = 1\ncount = 250"));
  EXPECT_EQ(cell_count(spec), 100'000U);
  EXPECT_NO_THROW(check_cells(spec));
}

TEST(SpecCells, hundreds_of_thousands_of_values_on_an_axis_are_read) {
  EXPECT_EQ(cell_count(parse(axis("camera.eye.x", "from = 0\nto = 10000\ncount = 300000"))), 300'000U);
}

TEST(SpecCells, too_many_are_refused) {
  const std::string thousand = "from = 0.001\nto = 1\ncount = 1000";
  EXPECT_EQ(parse_error(axis("combine.k_depth", thousand) + axis("combine.k_normal", thousand) +
                        axis("combine.threshold", thousand)),
            "/studies/s.toml: 1000000000 cells; at most 10,000,000");
}

TEST(CheckCells, names_the_cell_whose_settings_contradict_each_other) {
  const StudySpec spec =
      parse("[set]\nmodel.rabbit.shape = \"box\"\n" + axis("camera.near", "values = [1, 30]"));
  EXPECT_EQ(error_of([&] { check_cells(spec); }),
            "/studies/s.toml, cell near = 30: camera.near: = 30 is not below camera.far = 20");
}

TEST(CheckCells, names_the_cell_whose_files_are_missing) {
  const StudySpec mesh =
      parse("[[variant]]\nname = \"other\"\n[variant.set]\nmodel.rabbit.mesh = \"none.obj\"\n");
  EXPECT_EQ(error_of([&] { check_cells(mesh); }),
            "/studies/s.toml, cell other: model.rabbit.mesh: there is no file /studies/none.obj");
  const StudySpec ramp = parse("[set]\nmodel.rabbit.shape = \"box\"\nramp.diffuse = \"none.png\"\n");
  EXPECT_EQ(error_of([&] { check_cells(ramp); }),
            "/studies/s.toml: ramp.diffuse: there is no file /studies/none.png");
}

TEST(CheckCells, does_not_ask_for_files_that_nothing_draws) {
  EXPECT_NO_THROW(
      check_cells(parse("[set]\nmodel.rabbit.mesh = \"none.obj\"\nmodel.rabbit.visible = false\n")));
  EXPECT_NO_THROW(
      check_cells(parse("[set]\nmodel.rabbit.mesh = \"none.obj\"\nmodel.rabbit.shape = \"box\"\n")));
}

TEST(BundledSpecs, all_load_and_have_only_cells_that_can_be_drawn) {
  int specs = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(project_file("studies"))) {
    const bool is_search = entry.path().parent_path().filename() == "tuning";
    if (entry.path().extension() != ".toml" || is_search) continue;
    ++specs;
    try {
      const StudySpec spec = load_spec(entry.path());
      EXPECT_FALSE(spec.title.empty()) << entry.path();
      EXPECT_FALSE(spec.purpose.empty()) << entry.path();
      check_cells(spec);
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GE(specs, 15);
}

TEST(BundledSpecs, the_k_sweep_has_the_papers_choice_in_its_middle) {
  const StudySpec spec = load_spec(project_file("studies/k_sweep.toml"));
  ASSERT_EQ(cell_count(spec), 49U);
  const Settings middle = cell_settings(spec, make_cell(spec, 24));
  EXPECT_NEAR(middle.combine.k_depth, 0.003F, 1e-8F);
  EXPECT_NEAR(middle.combine.k_normal, 0.0125F, 1e-8F);
}

TEST(Spec, frames_of_a_path_are_views_of_every_cell) {
  const StudySpec spec = parse("[path]\nframes = 4\naxis = [0, 1, 0]\ndegrees = 360\n" +
                               axis("camera.eye.z", "values = [3, 5]") +
                               "[set]\ncamera.eye = [0, 0, 1]\ncamera.target = [0, 0, 0]\n");
  EXPECT_EQ(cell_count(spec), 2U);
  EXPECT_EQ(view_count(spec), 4U);
  EXPECT_EQ(spec.views[3].name, "frame_003");
  const Cell far_cell = make_cell(spec, 1);
  EXPECT_EQ(view_settings(spec, far_cell, 0).camera.eye, glm::vec3(0, 0, 5)) << "the cell's own camera turns";
  EXPECT_NEAR(view_settings(spec, far_cell, 1).camera.eye.x, 5, 1e-5);
  EXPECT_EQ(cell_settings(spec, far_cell).camera.eye, glm::vec3(0, 0, 5));
}

TEST(Spec, numbers_of_frames_have_as_many_digits_as_the_last) {
  EXPECT_EQ(parse("[path]\nframes = 2\n").views[1].name, "frame_001");
  EXPECT_EQ(parse("[path]\nframes = 1001\n").views[0].name, "frame_0000");
}

TEST(Spec, flicker_is_measured_along_a_path_alone_and_never_without_recall) {
  const auto measures = [](const std::string& text) { return parse(text).measures; };
  EXPECT_THAT(measures("measure = [\"flicker\", \"f1\"]\n[path]\n"), ElementsAre("recall", "flicker", "f1"));
  EXPECT_THAT(measures("measure = true\n[path]\n"), testing::Contains("flicker_reference"));
  EXPECT_THAT(measures("measure = true\n"), testing::Not(testing::Contains("flicker_reference")));
  EXPECT_THAT(parse_error("measure = [\"flicker\"]\n"), StartsWith(at(1, "the measure 'flicker' compares")));
}

TEST(Spec, more_frames_than_any_disk_holds_are_refused) {
  EXPECT_THAT(parse_error("[path]\nframes = 3600\n" +
                          axis("combine.k_depth", "from = 0.001\nto = 0.1\ncount = 9999")),
              HasSubstr("frames in all cells; at most 10,000,000"));
}

}  // namespace
}  // namespace inkbench
