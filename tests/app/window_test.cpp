// SPDX-License-Identifier: MIT
// The window itself: its first start, what it remembers, and that it sleeps when nothing happens.
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/app/app_test.h"

namespace inkbench {
namespace {

class AppWindow : public AppTest {};

TEST_F(AppWindow, first_start_shows_the_papers_scene_and_the_page_of_keys) {
  open_with({"--set", "image.width=128", "--set", "image.height=128"}, false);
  const Json now = settled();
  EXPECT_EQ(now["scene"], "paper.toml");
  EXPECT_EQ(parameter(now, "combine.k_depth"), "0.003");
  EXPECT_EQ(parameter(now, "combine.k_normal"), "0.0125");
  EXPECT_EQ(now["layout"]["show_welcome"], "true");
  click("start");
  wait_for("the page to close", [](const Json& one) { return one["layout"]["show_welcome"] == "false"; });
  quit();
}

TEST_F(AppWindow, next_start_brings_back_settings_dividers_and_theme) {
  open();
  drag(place("divider:left"), {place("divider:left").x + 60, place("divider:left").y});
  drag(place("bar:combine.threshold", 0.2), place("bar:combine.threshold", 0.3));
  wait_for("a step", [](const Json& now) { return now["steps"].size() == 1; });
  click("menu:View");
  click("menu:Light");
  wait_for("the theme", [](const Json& now) { return now["layout"]["theme"] == "\"light\""; });
  keys("j");
  wait_for("the judge", [](const Json& now) { return now["layout"]["side_page"] == "\"judge\""; });
  const Json before = settled();
  quit();
  open_with({});
  const Json after = state();
  EXPECT_EQ(after["layout"]["left"], before["layout"]["left"]);
  EXPECT_EQ(after["layout"]["theme"], before["layout"]["theme"]);
  EXPECT_EQ(after["layout"]["side_page"], before["layout"]["side_page"]);
  EXPECT_EQ(after["parameters"], before["parameters"]);
  EXPECT_EQ(after["scene"], "scene.toml");
}

TEST_F(AppWindow, first_sheet_leads_to_the_lines_and_a_tick_that_adds_a_buffer_is_kept) {
  open();
  const Json first = settled()["ui"];
  for (const char* there : {"normal", "depth_edges", "edge_class", "lines", "final"})
    EXPECT_TRUE(first.contains(std::string("tile:") + there)) << there;
  for (const char* left_out : {"motion", "pair_angles", "albedo"})
    EXPECT_FALSE(first.contains(std::string("tile:") + left_out)) << left_out;
  click("buffers");
  click("list:albedo");
  wait_for("its tile", [](const Json& now) { return now["ui"].contains("tile:albedo"); });
  keys("Escape");
  quit();
  open_with({});
  EXPECT_TRUE(state()["ui"].contains("tile:albedo"));
  EXPECT_FALSE(state()["ui"].contains("tile:motion"));
}

TEST_F(AppWindow, first_parameters_are_open_at_the_method_and_at_those_of_the_chosen_one) {
  open();
  choose_method("dihedral");
  const Json ui = wait_for("its parameters",
                           [](const Json& now) { return now["ui"].contains("bar:dihedral.angle"); })["ui"];
  EXPECT_FALSE(ui.contains("bar:combine.k_depth"));
}

TEST_F(AppWindow, draws_nothing_and_computes_nothing_while_nothing_happens) {
  open();
  input({"mousemove", "5", "715"});
  settled();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const long frames = settled()["frames"];
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  EXPECT_EQ(settled()["frames"], frames);
}

TEST_F(AppWindow, help_appears_while_the_mouse_rests_and_goes_when_it_leaves) {
  open();
  move_to(place("name:combine.threshold"));
  wait_for("the help", [](const Json& now) { return now["tooltip"].get<bool>(); });
  input({"mousemove", "5", "715"});
  wait_for("no help", [](const Json& now) { return !now["tooltip"].get<bool>(); });
}

TEST_F(AppWindow, newest_line_of_the_log_is_shown_when_nothing_else_happens) {
  write("study.toml",
        "title = \"t\"\nscene = \"scene.toml\"\nshow = [\"depth\"]\n[[axis]]\nkey = "
        "\"camera.eye.x\"\nfrom = -1\nto = 1\ncount = 20\n");
  open();
  open_by_dialog(file("study.toml"));
  keys("F3");
  for (const char* key : {"1", "2", "3", "4", "5", "6", "7", "8"}) keys(std::string("ctrl+") + key);
  keys("F3");
  click("run study");
  keys("F3");  // what the studies' page reads would draw more frames
  wait_for("the study's end", [](const Json& now) {
    return now["log"].back().get<std::string>().find("finished") != std::string::npos;
  });
  const Json after = settled();
  const std::string newest = "log:" + after["log"].back().get<std::string>();
  ASSERT_TRUE(after["ui"].contains(newest)) << after["ui"];
  EXPECT_GT(after["ui"][newest][3].get<double>() - after["ui"][newest][1].get<double>(), 8) << "wholly";
}

TEST_F(AppWindow, being_asked_to_end_by_the_system_keeps_layout_and_settings) {
  for (const int signal : {SIGTERM, SIGHUP}) {
    open();
    const Place edge = place("divider:left");
    drag(edge, {edge.x + (signal == SIGTERM ? 60 : -30), edge.y});
    drag(place("bar:combine.threshold", 0.2), place("bar:combine.threshold", 0.3));
    wait_for("a step", [](const Json& now) { return now["steps"].size() == 1; });
    const Json before = settled();
    send_signal(signal);
    EXPECT_EQ(wait_for_end(), 0);
    open_with({});
    EXPECT_EQ(state()["layout"], before["layout"]);
    EXPECT_EQ(state()["parameters"], before["parameters"]);
    EXPECT_EQ(state()["unsaved"], 0);
    quit();
  }
}

TEST_F(AppWindow, tab_leaves_the_pictures_alone_and_brings_the_panels_back) {
  open();
  const auto width = [](const Json& now) {
    return now["ui"]["tile:final"][2].get<double>() - now["ui"]["tile:final"][0].get<double>();
  };
  const double before = width(state());
  keys("Tab");
  wait_for("no panels", [](const Json& now) { return !now["ui"].contains("search"); });
  EXPECT_GT(width(settled()), before);
  keys("Tab");
  wait_for("the panels", [](const Json& now) { return now["ui"].contains("search"); });
  EXPECT_EQ(width(settled()), before);
}

}  // namespace
}  // namespace inkbench
