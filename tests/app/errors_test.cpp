// SPDX-License-Identifier: MIT
// What goes wrong is told and leaves the pictures as they were; what is mended goes on.
#include <fstream>
#include <thread>

#include "pipeline/base/files.h"
#include "tests/app/app_test.h"
#include "tests/cli/command.h"
#include "tests/places.h"

namespace inkbench {
namespace {

class AppErrors : public AppTest {
 protected:
  Json wait_for_problem_of(const std::string& name) {
    return wait_for("the problem of " + name,
                    [&](const Json& now) { return first_problem(now).find(name) != std::string::npos; });
  }
};

TEST_F(AppErrors, without_a_display_names_the_commands_that_need_none) {
  CommandOptions options;
  options.environment = {
      {"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"XDG_CONFIG_HOME", file("config").string()}};
  const CommandResult result = run_command({inkbench_program(), "app"}, options);
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("`inkbench render` and `inkbench study`"), std::string::npos) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST_F(AppErrors, missing_mesh_is_told_keeps_the_pictures_and_can_be_gone_back_from) {
  open();
  const Json before = state();
  click("group:model.ball");
  click("choice:model.ball.shape");
  click("choice:model.ball.shape=mesh");
  wait_for("the rabbit",
           [&](const Json& now) { return now["pictures"]["final"] != before["pictures"]["final"]; });
  const Json rabbit = settled();
  click("text:model.ball.mesh");
  wait_for_text_field();
  keys("ctrl+a");
  type("/no/such.obj");
  keys("Return");
  const Json told = wait_for("a problem", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_NE(first_problem(told).find("/no/such.obj"), std::string::npos);
  EXPECT_EQ(settled()["pictures"], rabbit["pictures"]);
  click("go back");
  const Json after = wait_for("no problem", [](const Json& now) { return now["problems"].empty(); });
  EXPECT_EQ(parameter(after, "model.ball.mesh"), parameter(rabbit, "model.ball.mesh"));
}

TEST_F(AppErrors, mesh_file_that_goes_away_is_still_drawn_and_a_broken_one_offers_the_last_good_step) {
  open();
  write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const std::string shape = parameter(state(), "model.ball.shape");
  open_by_dialog(file("t.obj"));
  wait_for("the mesh", [&](const Json& now) { return parameter(now, "model.ball.shape") != shape; });
  const Json before = settled();
  fs::remove(file("t.obj"));
  wait_for("the note", [](const Json& now) {
    return now["log"].back().get<std::string>().find("t.obj is gone") != std::string::npos;
  });
  keys("Home");
  const Json gone = settled();
  EXPECT_EQ(gone["problems"], Json::array());
  EXPECT_GT(runs(gone, "gbuffer"), runs(before, "gbuffer"));
  std::this_thread::sleep_for(std::chrono::seconds(1));  // files are looked at twice a second
  write("t.obj", "nonsense\n");
  wait_for_problem_of("t.obj");
  EXPECT_EQ(settled()["steps"].size(), 2U);
  click("go back");
  const Json after = wait_for("no problem", [](const Json& now) { return now["problems"].empty(); });
  EXPECT_EQ(parameter(after, "model.ball.shape"), shape);
  EXPECT_EQ(after["position"], 0);
}

TEST_F(AppErrors, going_back_is_offered_only_where_there_is_somewhere_to_go) {
  write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  write("scene.toml", "[[model]]\nname = \"tetra\"\nshape = \"mesh\"\nmesh = \"t.obj\"\n");
  open_with({"--scene", file("scene.toml").string()});
  write("t.obj", "nonsense\n");
  wait_for_problem_of("t.obj");
  const Json told = settled();
  EXPECT_TRUE(told["ui"].contains("dismiss"));
  EXPECT_FALSE(told["ui"].contains("go back"));
}

TEST_F(AppErrors, file_that_cannot_be_opened_is_told_in_the_window) {
  write("broken.toml", "[combine]\nk_dept = 1\n");
  write("scene.toml", small_scene());
  open_with({"--scene", file("scene.toml").string(), file("broken.toml").string()});
  const Json now = settled();
  ASSERT_EQ(now["problems"].size(), 1U);
  EXPECT_NE(first_problem(now).find("broken.toml:2"), std::string::npos) << now["problems"];
  EXPECT_TRUE(now["ui"].contains("tile:final"));
}

TEST_F(AppErrors, what_is_not_accepted_moves_no_picture_takes_its_own_clicks_and_goes_with_escape) {
  open();
  keys("1");  // one picture fills the window
  const Json before = settled();
  write("broken.toml", "[combine]\nk_dept = 1\n");
  open_by_dialog("broken.toml");
  wait_for("a problem", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_EQ(settled()["ui"]["tile:normal"], before["ui"]["tile:normal"]);
  const Json dismiss = settled()["ui"]["dismiss"];
  move_to({dismiss[0].get<int>() - 60, dismiss[3].get<int>()});
  input({"click", "1"});
  EXPECT_TRUE(settled()["view"]["marked"].is_null()) << "the picture below is not clicked";
  keys("Escape");
  const Json after = wait_for("no problem", [](const Json& now) { return now["problems"].empty(); });
  EXPECT_EQ(after["view"]["filled"], before["view"]["filled"]);
}

TEST_F(AppErrors, broken_shader_names_file_and_line_and_mending_it_draws_again) {
  open_with_own_shaders();
  const Json before = state();
  const fs::path shader = file("root/shaders/combine.frag");
  const std::string good = read_file(shader);
  std::string broken = good;
  const size_t line = broken.find("float sum = p.x + p.y;");
  ASSERT_NE(line, std::string::npos);
  broken.replace(line, 22, "float sum = p.x + q.y;");
  write_file_atomically(shader, broken);
  const Json told = wait_for("a problem", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_NE(first_problem(told).find("shaders/combine.frag:13"), std::string::npos) << told["problems"];
  EXPECT_EQ(told["pictures"], before["pictures"]);
  std::string mended = good;
  mended.replace(line, 22, "float sum = p.x + 2.0 * p.y;");
  write_file_atomically(shader, mended);
  wait_for("the shader", [&](const Json& now) {
    return now["problems"].empty() && now["pictures"]["final"] != before["pictures"]["final"];
  });
}

TEST_F(AppErrors, problem_of_shaders_stays_until_all_are_mended) {
  open_with_own_shaders();
  const std::vector<std::string> names{"combine.frag", "tile.frag", "ink.frag"};
  std::map<std::string, std::string> good;
  for (const std::string& name : names) {
    good[name] = read_file(file("root/shaders") / name);
    write_file_atomically(file("root/shaders") / name, good[name] + "nonsense\n");
    wait_for_problem_of("shaders/" + name);
  }
  const auto mend = [&](const std::string& name) {
    write_file_atomically(file("root/shaders") / name, good[name]);
  };
  mend("ink.frag");
  wait_for_problem_of("shaders/combine.frag");
  mend("combine.frag");
  wait_for_problem_of("shaders/tile.frag");
  mend("tile.frag");
  wait_for("no problem", [](const Json& now) { return now["problems"].empty(); });
}

}  // namespace
}  // namespace inkbench
