// SPDX-License-Identifier: MIT
// The form of a study: names that are free, a spec that runs, problems that say where they are.
#include "app/workbench/study_form.h"

#include "app/workbench/scene_base.h"
#include "pipeline/image/image_file.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class StudyFormTest : public testing::Test {
 protected:
  StudyForm sweep_form() const {
    StudyForm form = empty_form(paper_settings(), folder_.path() / "studies");
    form.request.axes = {suggested_axis(paper_settings(), "combine.k_depth")};
    return form;
  }
  CheckedForm check(const StudyForm& form) const {
    return check_form(form, paper_settings(), default_scene());
  }

  TemporaryFolder folder_;
};

TEST_F(StudyFormTest, sweep_is_named_after_what_it_varies_and_runs) {
  StudyForm form = sweep_form();
  const CheckedForm one = check(form);
  ASSERT_TRUE(one.spec) << one.problem;
  EXPECT_EQ(one.spec->title, "Sweep of k_depth");
  EXPECT_EQ(one.draft.path, folder_.path() / "studies/k_depth.toml");
  EXPECT_EQ(one.out, folder_.path() / "studies/k_depth");
  EXPECT_EQ(cell_count(*one.spec), 5U);
  form.request.axes.push_back(suggested_axis(paper_settings(), "camera.eye.x"));
  const CheckedForm two = check(form);
  ASSERT_TRUE(two.spec) << two.problem;
  EXPECT_EQ(two.spec->title, "k_depth by eye_x");
  EXPECT_EQ(two.draft.path.filename(), "k_depth_eye_x.toml");
  save_form(two);
  EXPECT_EQ(cell_count(load_spec(two.draft.path)), 25U);
}

TEST_F(StudyFormTest, size_is_the_forms) {
  StudyForm form = sweep_form();
  form.width_px = 200;
  form.height_px = 100;
  const CheckedForm checked = check(form);
  ASSERT_TRUE(checked.spec) << checked.problem;
  EXPECT_EQ(checked.spec->base.image.width, 200);
  EXPECT_EQ(checked.spec->base.image.height, 100);
}

TEST_F(StudyFormTest, another_study_gets_another_name_and_the_same_one_its_own) {
  StudyForm form = sweep_form();
  save_form(check(form));
  EXPECT_TRUE(check(form).is_saved) << "the same study continues";
  EXPECT_EQ(check(form).draft.path.filename(), "k_depth.toml");
  form.request.axes[0].count = 3;
  EXPECT_EQ(check(form).draft.path.filename(), "k_depth_2.toml");
  form.name = "k_depth";
  EXPECT_EQ(check(form).draft.path.filename(), "k_depth.toml");
  EXPECT_THAT(check(form).note, HasSubstr("will be replaced"));
}

TEST_F(StudyFormTest, bundled_spec_runs_as_it_is_until_it_is_changed) {
  const fs::path bundled = project_file("studies/k_sweep.toml");
  StudyForm form = form_of_file(bundled, folder_.path() / "studies");
  const CheckedForm same = check(form);
  ASSERT_TRUE(same.spec) << same.problem;
  EXPECT_EQ(same.draft.path, fs::absolute(bundled));
  EXPECT_TRUE(same.is_saved);
  EXPECT_EQ(same.out, folder_.path() / "studies/k_sweep");
  form.own_text->insert(0, "# mine\n");
  const CheckedForm changed = check(form);
  ASSERT_TRUE(changed.spec) << changed.problem;
  EXPECT_EQ(changed.draft.path, folder_.path() / "studies/k_sweep.toml");
  EXPECT_FALSE(changed.is_saved);
}

TEST_F(StudyFormTest, changed_spec_still_finds_what_lies_beside_the_spec_it_was) {
  folder_.write("mine/scene.toml", settings_text(paper_settings()));
  folder_.write("mine/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder_.write("mine/b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const fs::path source = folder_.write("mine/study.toml", R"(title = "a.obj"
scene = "scene.toml"
[set]
model.rabbit.mesh = 'a.obj'
[[axis]]
key = "model.rabbit.mesh"
values = ["a.obj",
          "b.obj", "rabbit"]
)");
  StudyForm form = form_of_file(source, folder_.path() / "studies");
  form.own_text->insert(0, "# mine\n");
  const CheckedForm changed = check(form);
  ASSERT_TRUE(changed.spec) << changed.problem;
  EXPECT_EQ(changed.draft.path, folder_.path() / "studies/study.toml");
  EXPECT_EQ(changed.spec->title, "a.obj");
  save_form(changed);
  const StudySpec saved = load_spec(changed.draft.path);
  check_cells(saved);
  EXPECT_EQ(saved.axes.at(0).values.at(1), Value((folder_.path() / "mine/b.obj").string()));
  EXPECT_EQ(saved.axes.at(0).values.at(2), Value(std::string("rabbit")));
  form.folder = source.parent_path();
  EXPECT_THAT(check(form).draft.text, HasSubstr("scene = \"scene.toml\""))
      << "paths stay as short as they are";
}

TEST_F(StudyFormTest, missing_file_of_a_changed_spec_is_looked_for_beside_the_spec_it_was) {
  const fs::path source = folder_.write(
      "mine/study.toml",
      "scene = \"data/scenes/paper.toml\"\n[[axis]]\nkey = \"combine.k_depth\"\nvalues = [1]\n");
  StudyForm form = form_of_file(source, folder_.path() / "studies");
  form.own_text->insert(0, "set.ramp.diffuse = \"none.png\"\n");
  const CheckedForm checked = check(form);
  ASSERT_TRUE(checked.spec) << "the project's scene: " << checked.problem;
  EXPECT_EQ(checked.spec->base.ramp.diffuse.image, (folder_.path() / "mine/none.png").string());
}

TEST_F(StudyFormTest, what_is_wrong_in_a_text_is_told_with_its_line) {
  StudyForm form = sweep_form();
  form.own_text = "title = \"T\"\n[[axis]]\nkey = \"combine.k_dept\"\nvalues = [1]\n";
  const CheckedForm checked = check(form);
  EXPECT_FALSE(checked.spec);
  EXPECT_THAT(checked.problem, AllOf(StartsWith("line 3: "), HasSubstr("k_depth")));
  form.own_text = "title = \n";
  EXPECT_THAT(check(form).problem, StartsWith("line 1: "));
}

TEST_F(StudyFormTest, what_is_wrong_in_the_form_is_told) {
  StudyForm form = sweep_form();
  form.request.axes.clear();
  EXPECT_THAT(check(form).problem, HasSubstr("over 0 parameters"));
  form = sweep_form();
  form.request.axes[0].from = -1;
  EXPECT_THAT(check(form).problem, HasSubstr("k_depth"));
  form = sweep_form();
  form.name = "../x";
  EXPECT_THAT(check(form).problem, HasSubstr("is not a file's name"));
  form = sweep_form();
  form.folder = "here";
  EXPECT_THAT(check(form).problem, HasSubstr("the folder"));
}

TEST_F(StudyFormTest, scene_that_is_open_is_named_and_not_copied) {
  Settings settings = paper_settings();
  settings.models.push_back(settings.models[1]);
  settings.models.back().name = "second";
  const fs::path scene = folder_.write("mine.toml", settings_text(settings));
  const StudyForm form = sweep_form();
  const CheckedForm checked = check_form(form, settings, scene);
  ASSERT_TRUE(checked.spec) << checked.problem;
  EXPECT_EQ(checked.draft.scene_text, "");
  EXPECT_THAT(checked.draft.text, HasSubstr("scene = \"" + scene.string() + "\""));
  save_form(checked);
  EXPECT_FALSE(fs::exists(form.folder / "k_depth_scene.toml"));
  EXPECT_EQ(load_spec(checked.draft.path).base.models.size(), settings.models.size());
}

TEST_F(StudyFormTest, models_that_no_file_has_are_checked_without_writing_anything) {
  Settings settings = paper_settings();
  settings.models.push_back(settings.models[1]);
  settings.models.back().name = "second";
  const StudyForm form = sweep_form();
  const CheckedForm checked = check_form(form, settings, {});
  ASSERT_TRUE(checked.spec) << checked.problem;
  EXPECT_FALSE(fs::exists(form.folder));
  save_form(checked);
  EXPECT_EQ(load_spec(checked.draft.path).base.models.size(), settings.models.size());
}

TEST_F(StudyFormTest, every_key_that_is_offered_can_be_swept) {
  const Settings settings = paper_settings();
  const std::vector<std::string> keys = sweepable_keys(settings);
  EXPECT_THAT(keys, Contains("combine.k_depth"));
  EXPECT_THAT(keys, Contains("camera.eye.x"));
  EXPECT_THAT(keys, Not(Contains("camera.eye")));
  for (const std::string& key : keys) EXPECT_NO_THROW(suggested_axis(settings, key)) << key;
}

TEST_F(StudyFormTest, grid_gives_the_spec_of_its_study) {
  const std::string spec = "title = \"T\"\n[[axis]]\nkey = \"camera.fov\"\nvalues = [20, 30]\n";
  const fs::path grid = folder_.path() / "grid.png";
  write_png(grid, Picture(4, 4, 3), {{"inkbench:spec", spec}});
  const StudyForm form = form_of_file(grid, folder_.path() / "studies");
  EXPECT_EQ(form.own_text, spec);
  EXPECT_TRUE(check(form).spec) << check(form).problem;
  write_png(grid, Picture(4, 4, 3), {});
  EXPECT_THAT(error_of([&] { form_of_file(grid, folder_.path()); }), HasSubstr("is no study"));
}

TEST_F(StudyFormTest, file_that_is_no_text_is_refused) {
  folder_.write("x.toml", std::string("\xff\xfe", 2));
  EXPECT_THAT(error_of([&] { form_of_file(folder_.path() / "x.toml", folder_.path()); }),
              HasSubstr("is no study"));
  EXPECT_THAT(error_of([&] { form_of_file(folder_.path() / "none.toml", folder_.path()); }),
              HasSubstr("none.toml"));
}

}  // namespace
}  // namespace inkbench
