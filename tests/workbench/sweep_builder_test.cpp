// SPDX-License-Identifier: MIT
// Sweeps as specs: parsed again, each cell has the very settings of the window but for what is swept.
#include "app/workbench/sweep_builder.h"

#include <cmath>

#include "app/workbench/scene_base.h"
#include "studies/sweep/spec.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

/// Settings with every kind of difference from the paper's scene.
Settings tuned() {
  Settings settings = paper_settings();
  settings.combine.k_depth = 0.1F / 3.0F;
  settings.camera.eye.y = 4.125F;
  settings.image.width = 300;
  settings.image.precision = Precision::unorm8;
  settings.ramp.diffuse.stops[1].colour = {0.1F, 0.2F, 0.3F};
  settings.ramp.specular = {{}, "/ramps/a \"b\".png"};
  settings.models[0].mesh = "/meshes/a b.ply";
  settings.lights[0].type = LightType::point;
  return settings;
}

class SweepTest : public testing::Test {
 protected:
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  /// Every cell of the saved draft against the settings with the swept values set.
  void expect_cells(const SweepRequest& request, const Settings& settings, const fs::path& scene) {
    const StudyDraft draft = draft_study(request, settings, scene, path("specs/sweep.toml"));
    save_study(draft);
    const StudySpec spec = load_spec(draft.path);
    ASSERT_EQ(spec.axes.size(), request.axes.size());
    EXPECT_EQ(spec.title, request.title);
    EXPECT_EQ(spec.show, request.show);
    EXPECT_EQ(spec.measures, request.measures);
    EXPECT_GT(cell_count(spec), 1U);
    for (size_t i = 0; i < cell_count(spec); ++i) {
      Settings expected = settings;
      for (const Assignment& assignment : make_cell(spec, i).set)
        set(expected, assignment.key, assignment.value);
      EXPECT_EQ(text(cell_settings(spec, make_cell(spec, i))), text(expected)) << i;
    }
  }

  TemporaryFolder folder_;
};

SweepAxis k_depth_axis() {
  return {.key = "combine.k_depth", .from = 0.001, .to = 0.009, .count = 3};
}

TEST_F(SweepTest, cells_have_the_windows_settings) {
  expect_cells({.axes = {k_depth_axis()}}, paper_settings(), default_scene());
  expect_cells({.axes = {k_depth_axis()}}, tuned(), default_scene());
  expect_cells({.title = "A \"grid\"",
                .axes = {k_depth_axis(), suggested_axis(tuned(), "camera.eye.x"),
                         suggested_axis(tuned(), "combine.use_normal")},
                .show = {BufferName::depth, BufferName::final},
                .measures = {"f1", "recall_crease"}},
               tuned(), default_scene());
}

TEST_F(SweepTest, every_parameter_that_can_be_swept_gives_a_spec_that_runs) {
  Settings settings = tuned();
  int swept = 0;
  for (const Param& param : list_params(settings)) {
    std::vector<std::string> keys{param.key};
    const bool has_components =
        param.field->type == FieldType::vector || param.field->type == FieldType::colour;
    if (has_components) keys = {param.key + ".x", param.key + ".y", param.key + ".z"};
    for (const std::string& key : keys) {
      if (!can_sweep(find_param(settings, key, "test"))) continue;
      SCOPED_TRACE(key);
      expect_cells({.axes = {suggested_axis(settings, key)}}, settings, default_scene());
      ++swept;
    }
  }
  EXPECT_GT(swept, 100);
}

TEST_F(SweepTest, an_axis_over_a_component_keeps_what_the_others_were_set_to) {
  Settings settings = paper_settings();
  settings.camera.eye = {1, 2, 30};
  expect_cells({.axes = {suggested_axis(settings, "camera.eye.y")}}, settings, default_scene());
}

TEST_F(SweepTest, values_are_those_of_the_range_and_scale) {
  const SweepRequest request{
      .axes = {{.key = "combine.k_depth", .from = 0.001, .to = 0.1, .count = 3, .scale = Scale::log},
               {.key = "camera.fov", .from = 20, .to = 40, .count = 3}}};
  const StudyDraft draft = draft_study(request, paper_settings(), default_scene(), path("s.toml"));
  const StudySpec spec = parse_spec(draft.text, draft.path, {});
  EXPECT_THAT(spec.axes[0].values, ElementsAre(Value(0.001F), Value(0.01F), Value(0.1F)));
  EXPECT_THAT(spec.axes[1].values, ElementsAre(Value(20.0F), Value(30.0F), Value(40.0F)));
}

TEST_F(SweepTest, the_spec_says_only_what_differs) {
  Settings settings = paper_settings();
  settings.combine.k_normal = 0.02F;
  settings.combine.k_depth = 0.5F;  // swept: no need to set it
  const StudyDraft draft =
      draft_study({.title = "T", .axes = {k_depth_axis()}}, settings, default_scene(), path("s.toml"));
  EXPECT_EQ(
      draft.text,
      "title = \"T\"\nscene = \"data/scenes/paper.toml\"\nshow = [\"final\"]\n"
      "\n[set]\ncombine.k_normal = 0.02\n"
      "\n[[axis]]\nkey = \"combine.k_depth\"\nfrom = 0.001\nto = 0.009\ncount = 3\nscale = \"linear\"\n");
  EXPECT_EQ(draft.scene_text, "");
}

TEST_F(SweepTest, a_scene_beside_the_spec_is_named_from_there) {
  const fs::path scene = folder_.write("specs/scenes/mine.toml", settings_text(paper_settings()));
  const StudyDraft draft = draft_study({.axes = {k_depth_axis()}}, tuned(), scene, path("specs/s.toml"));
  EXPECT_THAT(draft.text, HasSubstr("scene = \"scenes/mine.toml\""));
  expect_cells({.axes = {k_depth_axis()}}, tuned(), scene);
}

TEST_F(SweepTest, a_scene_elsewhere_is_named_in_full) {
  const fs::path scene = folder_.write("mine.toml", settings_text(paper_settings()));
  const StudyDraft draft = draft_study({.axes = {k_depth_axis()}}, tuned(), scene, path("specs/s.toml"));
  EXPECT_THAT(draft.text, HasSubstr("scene = \"" + scene.string() + "\""));
  expect_cells({.axes = {k_depth_axis()}}, tuned(), scene);
}

TEST_F(SweepTest, a_namesake_of_the_projects_scene_beside_the_spec_is_not_taken_for_it) {
  folder_.write("specs/data/scenes/paper.toml", "combine.k_depth = 0.5\n");
  expect_cells({.axes = {suggested_axis(paper_settings(), "camera.fov")}}, paper_settings(), default_scene());
}

TEST_F(SweepTest, other_models_than_any_scenes_bring_a_scene_file_along) {
  Settings settings = tuned();
  settings.models.emplace_back().name = "extra";
  settings.models.back().shape = Shape::torus;
  const StudyDraft draft =
      draft_study({.axes = {k_depth_axis()}}, settings, default_scene(), path("specs/sweep.toml"));
  EXPECT_EQ(draft.scene_path, path("specs/sweep_scene.toml"));
  EXPECT_THAT(draft.text, HasSubstr("scene = \"sweep_scene.toml\""));
  EXPECT_THAT(draft.text, Not(HasSubstr("[set]")));
  expect_cells({.axes = {k_depth_axis()}}, settings, default_scene());
  expect_cells({.axes = {suggested_axis(settings, "model.extra.tube")}}, settings, "");
}

TEST_F(SweepTest, a_scene_that_is_gone_or_broken_is_passed_over) {
  for (const fs::path& scene : {path("none.toml"), folder_.write("bad.toml", "[["), fs::path()}) {
    const StudyDraft draft = draft_study({.axes = {k_depth_axis()}}, tuned(), scene, path("s.toml"));
    EXPECT_THAT(draft.text, HasSubstr("data/scenes/paper.toml"));
  }
}

TEST_F(SweepTest, relative_paths_in_settings_become_absolute) {
  Settings settings = paper_settings();
  settings.models[0].mesh = "meshes/a.ply";
  const StudyDraft draft = draft_study({.axes = {k_depth_axis()}}, settings, default_scene(), path("s.toml"));
  EXPECT_THAT(draft.text, HasSubstr((fs::current_path() / "meshes/a.ply").string()));
}

TEST_F(SweepTest, suggested_ranges_lie_around_the_present_value) {
  const auto expect_range = [](const Settings& settings, const std::string& key, double from, double to) {
    const SweepAxis axis = suggested_axis(settings, key);
    EXPECT_DOUBLE_EQ(axis.from, from) << key;
    EXPECT_DOUBLE_EQ(axis.to, to) << key;
  };
  Settings settings = paper_settings();
  expect_range(settings, "combine.k_depth", 0.00075, 0.012);
  expect_range(settings, "combine.threshold", 0.25, 1.25);
  expect_range(settings, "light.key.direction.x", 0.05, 1.0);
  expect_range(settings, "mesh.faces", 100, 100000);  // 0 has no place on a log scale
  settings.mesh.faces = 2001;
  expect_range(settings, "mesh.faces", 500, 8004);
  settings.combine.k_depth = 1.0F;
  expect_range(settings, "combine.k_depth", 0.25, 1.0);
  settings.mesh.subdivide = 0;
  EXPECT_LE(suggested_axis(settings, "mesh.subdivide").count, 5);
  EXPECT_THAT(suggested_axis(settings, "combine.use_depth").values, SizeIs(2));
  EXPECT_THAT(suggested_axis(settings, "mesh.normals").values, SizeIs(4));
}

TEST_F(SweepTest, the_middle_of_a_suggested_range_is_the_present_value) {
  const StudyDraft draft = draft_study({.axes = {suggested_axis(paper_settings(), "combine.k_depth")}},
                                       paper_settings(), default_scene(), path("s.toml"));
  EXPECT_EQ(parse_spec(draft.text, draft.path, {}).axes[0].values[2], Value(0.003F));
}

TEST_F(SweepTest, what_cannot_be_swept_is_an_error) {
  const Settings settings = paper_settings();
  const auto suggest_error = [&](const std::string& key) {
    return error_of([&] { suggested_axis(settings, key); });
  };
  EXPECT_EQ(suggest_error("camera.eye"),
            "sweep of camera.eye: is a vector; sweep one component: camera.eye.x");
  EXPECT_THAT(suggest_error("ramp.diffuse"), HasSubstr("is a ramp; sweep a number or a choice"));
  EXPECT_THAT(suggest_error("model.rabbit.mesh"), HasSubstr("is a text"));
  EXPECT_THAT(suggest_error("combine.k_dept"), HasSubstr("did you mean 'combine.k_depth'?"));
}

TEST_F(SweepTest, bad_axes_are_errors) {
  const auto error = [&](std::vector<SweepAxis> axes) {
    return error_of([&] { draft_study({.axes = std::move(axes)}, paper_settings(), "", path("s.toml")); });
  };
  const auto k = [](double from, double to, int count, Scale scale = Scale::linear) {
    return SweepAxis{.key = "combine.k_depth", .from = from, .to = to, .count = count, .scale = scale};
  };
  EXPECT_THAT(error({}), HasSubstr("give one to three"));
  EXPECT_THAT(error({k(0.1, 0.2, 3), k(0.1, 0.2, 3)}), HasSubstr("are the same parameter"));
  EXPECT_THAT(error({k(0.1, 7, 3)}), HasSubstr("combine.k_depth = 7 is out of range"));
  EXPECT_THAT(error({k(0.1, std::nan(""), 3)}), HasSubstr("out of range"));
  EXPECT_THAT(error({k(0.1, 0.2, 0)}), HasSubstr("0 steps; give 1 to 1000"));
  EXPECT_THAT(error({k(0.1, 0.1, 3)}), HasSubstr("from and to are both 0.1"));
  EXPECT_THAT(error({{.key = "camera.eye.x", .from = -1, .to = 1, .scale = Scale::log}}),
              HasSubstr("both must be above 0"));
  EXPECT_THAT(error({{.key = "camera.eye", .from = 0, .to = 1}}), HasSubstr("list its values"));
  EXPECT_THAT(error({{.key = "camera.fov", .values = {Value(true)}}}),
              HasSubstr("true is not a value of it"));
  EXPECT_THAT(error({{.key = "camera.fov", .values = {Value(999.0F)}}}), HasSubstr("out of range"));
}

}  // namespace
}  // namespace inkbench
