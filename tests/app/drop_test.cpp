// SPDX-License-Identifier: MIT
// Files dropped on the window, as from a file manager: each does what its content says.
#include "pipeline/base/files.h"
#include "pipeline/image/image_file.h"
#include "tests/app/app_test.h"
#include "tests/app/drop_source.h"
#include "tests/cli/command.h"
#include "tests/places.h"

namespace inkbench {
namespace {

constexpr const char* kWedge = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

class AppDrop : public AppTest {
 protected:
  AppDrop() { write("wedge.obj", kWedge); }

  void drop_files(const std::vector<fs::path>& files) { drop(environment_.at("DISPLAY"), uri_list(files)); }
  std::string k_normal(const Json& now) const { return parameter(now, "combine.k_normal"); }
  Json wait_for_parameter(const std::string& key, const std::string& value) {
    return wait_for(key + " = " + value, [&](const Json& now) { return parameter(now, key) == value; });
  }
  /// A picture of the scene with other settings, under any name.
  fs::path export_picture(const std::string& k, const fs::path& name) {
    const CommandResult result =
        run_command({inkbench_program(), "render", "--scene", file("scene.toml").string(), "--set",
                     "combine.k_normal=" + k, "--set", "camera.fov=50", "--buffers", "final", "--out",
                     file("out").string()},
                    {.environment = environment_});
    EXPECT_EQ(result.status, 0) << result.err;
    fs::rename(file("out/final.png"), name);
    return name;
  }
  void expect_same(const Json& now, const Json& before) {
    for (const char* what : {"scene", "parameters", "steps", "pictures", "recent"})
      EXPECT_EQ(now[what], before[what]) << what;
  }
};

TEST_F(AppDrop, exported_picture_brings_its_parameters_back_in_one_step) {
  open();
  const Json before = state();
  drop_files({export_picture("0.5", file("picture.png"))});
  const Json after = wait_for_parameter("combine.k_normal", "0.5");
  EXPECT_EQ(parameter(after, "camera.fov"), "50");
  EXPECT_EQ(after["steps"], Json::parse(R"(["open picture.png"])"));
  EXPECT_EQ(after["view"]["selected"], "final");
  EXPECT_EQ(after["recent"][0], file("picture.png").string());
  EXPECT_NE(settled()["pictures"]["final"], before["pictures"]["final"]);
  keys("ctrl+z");
  wait_for_parameter("combine.k_normal", k_normal(before));
  const Json undone = settled();
  EXPECT_EQ(undone["parameters"], before["parameters"]);
  EXPECT_EQ(undone["pictures"], before["pictures"]);
}

TEST_F(AppDrop, mesh_replaces_the_main_model) {
  open();
  const Json before = state();
  drop_files({file("wedge.obj")});
  const Json after = wait_for_parameter("model.ball.mesh", "\"" + file("wedge.obj").string() + "\"");
  EXPECT_EQ(parameter(after, "model.ball.shape"), "\"mesh\"");
  EXPECT_EQ(parameter(after, "model.block.shape"), "\"box\"");
  EXPECT_NE(settled()["pictures"]["final"], before["pictures"]["final"]);
  EXPECT_TRUE(state()["problems"].empty()) << state()["problems"];
  keys("ctrl+z");
  wait_for_parameter("model.ball.shape", "\"sphere\"");
}

TEST_F(AppDrop, mesh_is_drawn_by_the_method_that_was_chosen) {
  open();
  choose_method("mitchell");
  const Json before = settled();
  drop_files({file("wedge.obj")});
  wait_for_parameter("model.ball.shape", "\"mesh\"");
  const Json after = settled();
  EXPECT_EQ(parameter(after, "edges.method"), "\"mitchell\"");
  EXPECT_GT(runs(after, "mitchell"), runs(before, "mitchell"));
  EXPECT_EQ(runs(after, "decaudin"), 0);
}

TEST_F(AppDrop, scene_is_opened) {
  open();
  write("other.toml", "base = \"scene.toml\"\n[combine]\nk_normal = 0.5\n");
  drop_files({file("other.toml")});
  EXPECT_EQ(wait_for_parameter("combine.k_normal", "0.5")["scene"], "other.toml");
}

TEST_F(AppDrop, study_and_the_grid_of_one_are_opened_as_a_form) {
  open();
  const std::string scene = "scene = \"" + file("scene.toml").string() + "\"\nsize = [64, 64]\n";
  write("sweep.toml", scene + "[[axis]]\nkey = \"combine.k_normal\"\nvalues = [0.1, 0.2, 0.3]\n");
  const auto wait_for_form = [&](const std::string& spec) {
    return wait_for("the form of " + spec, [&](const Json& now) {
      const Json& form = now["studies"]["form"];
      return !form.is_null() && form["spec"].get<std::string>().ends_with(spec) && form["cells"] == 3;
    });
  };
  drop_files({file("sweep.toml")});
  EXPECT_EQ(wait_for_form("/sweep.toml")["studies"]["form"]["problem"], "");
  const CommandResult result =
      run_command({inkbench_program(), "study", file("sweep.toml").string(), "--out", file("out").string()},
                  {.environment = environment_});
  ASSERT_EQ(result.status, 0) << result.err;
  drop_files({file("out/grid.png")});
  EXPECT_EQ(wait_for_form("/grid.toml")["studies"]["form"]["problem"], "");
}

TEST_F(AppDrop, names_may_have_blanks_and_any_letters) {
  open();
  const fs::path name = file("Größe 50% #1 & 線画 [x];y+z.png");
  drop_files({export_picture("0.5", name)});
  EXPECT_EQ(wait_for_parameter("combine.k_normal", "0.5")["scene"], name.filename().string());
}

TEST_F(AppDrop, several_files_are_opened_one_after_the_other) {
  open();
  drop_files({export_picture("0.5", file("a picture.png")), file("wedge.obj")});
  const Json after = wait_for_parameter("model.ball.mesh", "\"" + file("wedge.obj").string() + "\"");
  EXPECT_EQ(k_normal(after), "0.5");
  EXPECT_EQ(after["steps"], Json::parse(R"(["open a picture.png", "open wedge.obj"])"));
}

TEST_F(AppDrop, unknown_file_is_told_and_changes_nothing) {
  open();
  write("notes.bin", std::string("\0\1\2 nothing", 10));
  const Json before = state();
  drop_files({file("notes.bin")});
  const Json told = wait_for("a problem", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_NE(first_problem(told).find("notes.bin"), std::string::npos) << told["problems"];
  EXPECT_NE(first_problem(told).find("is no file that inkbench can open"), std::string::npos);
  expect_same(settled(), before);
  drop_files({file("wedge.obj")});
  wait_for("no problem", [](const Json& now) { return now["problems"].empty(); });
}

TEST_F(AppDrop, unknown_files_among_others_are_told) {
  open();
  write("notes.bin", "nothing");
  write("broken.obj", "f 1 2 3\n");
  drop_files({file("notes.bin"), file("broken.obj"), file("wedge.obj")});
  const Json after = wait_for_parameter("model.ball.mesh", "\"" + file("wedge.obj").string() + "\"");
  EXPECT_NE(first_problem(after).find("notes.bin"), std::string::npos) << after["problems"];
  EXPECT_NE(first_problem(after).find("broken.obj"), std::string::npos) << after["problems"];
  EXPECT_EQ(after["steps"].size(), 1U);
}

TEST_F(AppDrop, image_without_parameters_is_asked_about) {
  open();
  write_png(file("photo.png"), Picture(8, 2, 3, 100), {});
  const Json before = state();
  drop_files({file("photo.png")});
  const auto wait_for_question = [&](bool there) {
    wait_for(there ? "the question" : "no question",
             [&](const Json& now) { return now["ui"].contains("image question:leave") == there; });
  };
  wait_for_question(true);
  expect_same(settled(), before);
  keys("Escape");
  wait_for_question(false);
  expect_same(settled(), before);
  drop_files({file("photo.png")});
  wait_for_question(true);
  click("image question:diffuse");
  wait_for_parameter("ramp.diffuse", "\"" + file("photo.png").string() + "\"");
  wait_for_question(false);
  EXPECT_EQ(settled()["steps"], Json::parse(R"(["diffuse ramp from photo.png"])"));
}

TEST_F(AppDrop, folder_and_what_is_gone_change_nothing) {
  open();
  const Json before = state();
  drop_files({file("none.png"), file("")});
  const Json told = wait_for("a problem", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_NE(first_problem(told).find("no such file"), std::string::npos) << told["problems"];
  EXPECT_NE(first_problem(told).find("is a folder"), std::string::npos) << told["problems"];
  expect_same(settled(), before);
}

}  // namespace
}  // namespace inkbench
