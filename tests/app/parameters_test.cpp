// SPDX-License-Identifier: MIT
// Tuning: sliders, typing, resetting, searching, undoing.
#include <cmath>

#include "tests/app/app_test.h"

namespace inkbench {
namespace {

class AppParameters : public AppTest {};

TEST_F(AppParameters, dragging_k_changes_the_lines_and_runs_only_what_lies_below) {
  open();
  const Json before = state();
  const std::string key = "combine.k_normal";
  drag(place("bar:" + key, 0.5), place("bar:" + key, 0.9));
  wait_for("the drag's end", [&](const Json& now) { return now["steps"].size() == 1; });
  const Json after = settled();
  EXPECT_GT(std::stod(parameter(after, key)), 0.1);
  EXPECT_NE(after["pictures"]["combined_edges"], before["pictures"]["combined_edges"]);
  EXPECT_NE(after["pictures"]["final"], before["pictures"]["final"]);
  for (const char* same : {"normal", "depth", "normal_edges", "depth_edges", "shaded", "reference"})
    EXPECT_EQ(after["pictures"][same], before["pictures"][same]) << same;
  for (const char* pass : {"gbuffer", "gradient", "range", "shade", "blinn_phong"})
    EXPECT_EQ(runs(after, pass), runs(before, pass)) << pass;
  EXPECT_GT(runs(after, "combine"), runs(before, "combine"));
  EXPECT_GT(runs(after, "ink"), runs(before, "ink"));
  EXPECT_TRUE(after["passes"]["combine"]["ran"]);
  EXPECT_FALSE(after["passes"]["gbuffer"]["ran"]);
  EXPECT_EQ(after["steps"].size(), 1U) << "a drag is one step";
}

TEST_F(AppParameters, undo_and_redo_take_a_drag_back_and_make_it_again) {
  open();
  const std::string key = "combine.threshold";
  const std::string before = parameter(state(), key);
  drag(place("bar:" + key, 0.4), place("bar:" + key, 0.8));
  wait_for("a step", [](const Json& now) { return now["steps"].size() == 1; });
  const std::string dragged = parameter(settled(), key);
  EXPECT_NE(dragged, before);
  keys("ctrl+z");
  wait_for("undo", [&](const Json& now) { return parameter(now, key) == before; });
  keys("ctrl+y");
  wait_for("redo", [&](const Json& now) { return parameter(now, key) == dragged; });
}

TEST_F(AppParameters, control_click_types_a_number_and_right_click_resets_it) {
  open();
  const std::string key = "combine.k_depth";
  const std::string before = parameter(state(), key);
  type_over("bar:" + key, "0.00123");
  const Json typed =
      wait_for("the number", [&](const Json& now) { return parameter(now, key) == "0.00123"; });
  EXPECT_TRUE(typed["problems"].empty()) << typed["problems"];
  wait_for("the mark", [&](const Json& now) { return now["ui"].contains("changed:" + key); });
  click("bar:" + key, 3);
  wait_for("the reset", [&](const Json& now) { return parameter(now, key) == before; });
  wait_for("no mark", [&](const Json& now) { return !now["ui"].contains("changed:" + key); });
}

TEST_F(AppParameters, tab_takes_the_number_and_goes_on_to_the_next) {
  open();
  input({"keydown", "ctrl"});
  click("bar:combine.k_depth");
  wait_for_text_field();
  input({"keyup", "ctrl"});
  type("0.002");
  keys("Tab");
  wait_for("the first number", [&](const Json& now) { return parameter(now, "combine.k_depth") == "0.002"; });
  type("0.03");
  keys("Return");
  wait_for("the second", [&](const Json& now) { return parameter(now, "combine.k_normal") == "0.03"; });
  EXPECT_TRUE(state()["ui"].contains("search")) << "the panels are still there";
}

TEST_F(AppParameters, what_is_typed_right_after_the_search_key_goes_into_the_search) {
  open();
  const Json before = state();
  input({"key", "--delay", "0", "ctrl+f", "z", "f", "c"});
  const Json after = settled();
  EXPECT_EQ(after["view"]["magnification"], before["view"]["magnification"]);
  EXPECT_FALSE(after["view"]["comparison"]["active"].get<bool>());
  EXPECT_FALSE(after["ui"].contains("bar:combine.threshold")) << "no help has that word";
}

TEST_F(AppParameters, number_outside_the_limits_is_told_and_changes_nothing) {
  open();
  const std::string key = "combine.threshold";
  const std::string before = parameter(state(), key);
  type_over("bar:" + key, "77");
  const Json told = wait_for("a problem", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_NE(first_problem(told).find(key), std::string::npos) << told["problems"];
  EXPECT_EQ(parameter(told, key), before);
  click("dismiss");
  wait_for("no problem", [](const Json& now) { return now["problems"].empty(); });
}

TEST_F(AppParameters, search_finds_by_key_and_help_and_escape_ends_it) {
  open();
  EXPECT_FALSE(state()["ui"].contains("bar:camera.fov")) << "its group is closed";
  keys("ctrl+f");
  wait_for_text_field();
  type("field of view");
  wait_for("the search", [](const Json& now) {
    return now["ui"].contains("bar:camera.fov") && !now["ui"].contains("bar:combine.k_depth");
  });
  keys("Escape");
  wait_for("all parameters", [](const Json& now) { return now["ui"].contains("bar:combine.k_depth"); });
}

TEST_F(AppParameters, typed_text_with_shortcut_letters_is_only_text) {
  open();
  keys("ctrl+f");
  wait_for_text_field();
  type("czpvo1");
  const Json now =
      wait_for("the search", [](const Json& one) { return !one["ui"].contains("bar:combine.k_depth"); });
  EXPECT_EQ(now["view"]["filled"], "");
  EXPECT_FALSE(now["view"]["comparison"]["active"]);
  EXPECT_EQ(now["view"]["tool"], "view");
}

TEST_F(AppParameters, choice_and_switch_change_by_click) {
  open();
  click("check:combine.use_depth");
  wait_for("the switch", [&](const Json& now) { return parameter(now, "combine.use_depth") == "false"; });
  click("group:image");
  click("choice:image.precision");
  click("choice:image.precision=unorm8");
  wait_for("the choice", [&](const Json& now) {
    return parameter(now, "image.precision") == "\"unorm8\"" && runs(now, "quantise") > 0;
  });
}

}  // namespace
}  // namespace inkbench
