// SPDX-License-Identifier: MIT
// What a fit may move, the spec that it is run by, and for which settings its result says something.
#include "app/workbench/fit_spec.h"

#include "pipeline/settings/settings_file.h"
#include "studies/tuning/tune_spec.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> first_ticks(const Settings& settings) {
  std::vector<std::string> keys = usual_fit_keys(settings);
  std::erase_if(keys, [&](const std::string& key) { return !is_fitted_at_first(settings, key); });
  return keys;
}

Settings with_method(const std::string& method) {
  Settings settings = paper_settings();
  set(settings, "edges.method", method);
  return settings;
}

FitRequest small_request() {
  return {paper_settings(), {"combine.k_depth", "combine.k_normal"}, {}, 50, {}};
}

TEST(FitSpec, the_papers_two_coefficients_are_ticked_at_first) {
  EXPECT_THAT(first_ticks(paper_settings()), ElementsAre("combine.k_depth", "combine.k_normal"));
}

TEST(FitSpec, another_methods_numbers_are_ticked_and_what_follows_it_is_offered) {
  const Settings settings = with_method("dihedral");
  EXPECT_THAT(first_ticks(settings), ElementsAre("dihedral.angle", "dihedral.gap"));
  EXPECT_THAT(usual_fit_keys(settings), Contains("edges.weak"));
  EXPECT_THAT(usual_fit_keys(settings), Not(Contains("combine.k_depth")));
}

TEST(FitSpec, what_lines_are_judged_by_cannot_move) {
  const Settings settings = paper_settings();
  for (const char* key : {"judge.tolerance", "camera.fov", "image.width", "edges.method", "no.such",
                          "camera.eye", "dihedral.angle"})
    EXPECT_FALSE(can_fit(settings, key)) << key;
  for (const char* key : {"combine.use_depth", "mesh.faces", "combine.threshold"})
    EXPECT_TRUE(can_fit(settings, key)) << key;
}

TEST(FitSpec, the_spec_is_one_that_tune_reads_with_the_very_settings) {
  FitRequest request = small_request();
  set(request.settings, "combine.threshold", 0.5F);
  request.cameras = {request.settings.camera, request.settings.camera};
  request.cameras[1].eye.x += 2;
  const TemporaryFolder folder;
  folder.write("scene.toml", fit_scene_text(request));
  const auto file = folder.write("fit.toml", fit_spec_text(request, "scene.toml"));
  const TuneSpec spec = load_tune_spec(file);
  EXPECT_EQ(text(spec.base), text(load_settings(folder.path() / "scene.toml")));
  EXPECT_EQ(spec.base.combine.threshold, 0.5F);
  EXPECT_EQ(spec.budget, 50);
  ASSERT_EQ(spec.space.size(), 2U);
  EXPECT_EQ(spec.space[1].key, "combine.k_normal");
  ASSERT_EQ(spec.pictures.size(), 2U);
  EXPECT_EQ(group_text(picture_settings(spec, spec.pictures[0]).camera), group_text(request.cameras[0]));
  EXPECT_EQ(group_text(picture_settings(spec, spec.pictures[1]).camera), group_text(request.cameras[1]));
}

TEST(FitSpec, without_a_tick_there_is_nothing_to_search) {
  FitRequest request = small_request();
  request.keys.clear();
  EXPECT_THAT(error_of([&] { fit_spec_text(request, "scene.toml"); }), HasSubstr("no parameter is ticked"));
  request.keys = {"judge.tolerance"};
  EXPECT_THAT(error_of([&] { fit_spec_text(request, "scene.toml"); }),
              HasSubstr("judge.tolerance cannot be fitted"));
}

TEST(FitSpec, a_result_holds_until_something_moves_that_it_depends_on) {
  const FitRequest request = small_request();
  Settings settings = request.settings;
  set(settings, "combine.k_depth", 0.02F);
  set(settings, "ink.colour", glm::vec3(1, 0, 0));
  EXPECT_TRUE(is_still_about(request, settings));
  for (const auto& [key, value] : {std::pair<std::string, Value>("combine.threshold", 0.5F),
                                   {"edges.method", std::string("dihedral")},
                                   {"image.width", 300},
                                   {"camera.fov", 30.0F}}) {
    Settings other = settings;
    set(other, key, value);
    EXPECT_FALSE(is_still_about(request, other)) << key;
  }
  settings.models.pop_back();
  EXPECT_FALSE(is_still_about(request, settings));
}

TEST(FitSpec, judged_from_kept_cameras_the_camera_may_move) {
  FitRequest request = small_request();
  request.cameras = {request.settings.camera};
  Settings settings = request.settings;
  set(settings, "camera.fov", 30.0F);
  EXPECT_TRUE(is_still_about(request, settings));
}

TEST(FitSpec, marks_are_judged_from_their_own_cameras_beside_the_others) {
  const Settings settings = paper_settings();
  CameraParams kept = settings.camera, marked = settings.camera;
  kept.eye.x += 1;
  marked.eye.x += 2;
  const PaintedMarks marks{{marked, settings.image.width, settings.image.height, "unread"}};
  const std::vector<CameraParams> cameras{kept};
  FitOptions options;
  EXPECT_EQ(fit_cameras(settings, cameras, marks, options).size(), 2U);
  EXPECT_EQ(fit_cameras(settings, {}, marks, options).size(), 2U) << "the present one and the marks'";
  options.uses_reference = false;
  const std::vector<CameraParams> alone = fit_cameras(settings, cameras, marks, options);
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_TRUE(same_camera(alone[0], marked));
  EXPECT_TRUE(fit_cameras(settings, {}, {}, options).empty()) << "the present one alone";
}

TEST(FitSpec, marks_of_another_size_or_not_wanted_do_not_count) {
  const Settings settings = paper_settings();
  const PaintedMarks marks{{settings.camera, settings.image.width, settings.image.height, "unread"},
                           {settings.camera, 7, 5, "unread"}};
  FitOptions options;
  EXPECT_EQ(fit_marks(settings, marks, options).size(), 1U);
  options.uses_marks = false;
  EXPECT_TRUE(fit_marks(settings, marks, options).empty());
}

TEST(FitSpec, marks_stand_in_the_spec_that_tune_reads) {
  FitRequest request = small_request();
  request.settings.image.width = 4;
  request.settings.image.height = 1;
  request.uses_reference = false;
  request.marks = {{request.settings.camera, 4, 1, ".wUu"}};
  const TemporaryFolder folder;
  folder.write("scene.toml", fit_scene_text(request));
  const std::string text = fit_spec_text(request, "scene.toml") + write_fit_marks(folder.path(), request);
  const TuneSpec spec = load_tune_spec(folder.write("fit.toml", text));
  ASSERT_TRUE(spec.pictures.size() == 1 && spec.pictures[0].marks);
  EXPECT_TRUE(spec.pictures[0].marks->marks.unwanted.at(2, 0));
  EXPECT_EQ(spec.objective.text(), "marks");
}

}  // namespace
}  // namespace inkbench
