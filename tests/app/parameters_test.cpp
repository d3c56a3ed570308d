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

TEST_F(AppParameters, what_is_typed_into_a_slow_window_goes_into_the_number_that_was_clicked) {
  open();
  const std::string key = "combine.threshold";
  const Place at = place("bar:" + key);
  while_it_stands_still([&] {
    xdotool({"mousemove", std::to_string(at.x), std::to_string(at.y), "keydown", "ctrl", "click", "1",
             "keyup", "ctrl", "type", "--delay", "0", "0.51"});
  });
  keys("Return");
  const Json after = wait_for("the number", [&](const Json& now) { return parameter(now, key) == "0.51"; });
  EXPECT_EQ(after["view"]["filled"], "") << "a digit is no shortcut there";
}

TEST_F(AppParameters, tab_in_a_slow_window_loses_no_digit_of_the_next_number) {
  open();
  const Place at = place("bar:combine.k_depth");
  while_it_stands_still([&] {
    xdotool({"mousemove", std::to_string(at.x), std::to_string(at.y), "keydown", "ctrl", "click", "1",
             "keyup", "ctrl", "type", "--delay", "0", "0.002\t0.03"});
  });
  keys("Return");
  const Json after = wait_for("both numbers", [&](const Json& now) {
    return parameter(now, "combine.k_depth") == "0.002" && parameter(now, "combine.k_normal") == "0.03";
  });
  EXPECT_EQ(after["view"]["filled"], "");
}

TEST_F(AppParameters, dragging_with_shift_moves_a_value_a_tenth_as_far_from_where_it_is) {
  open();
  const std::string key = "combine.threshold";
  const auto value = [&] { return std::stod(parameter(settled(), key)); };
  const Place low = place("bar:" + key, 0.3), high = place("bar:" + key, 0.7);
  input({"mousemove", std::to_string(low.x), std::to_string(low.y), "click", "1"});
  const double low_value = value();
  input({"mousemove", std::to_string(high.x), std::to_string(high.y), "click", "1"});
  const double high_value = value();
  ASSERT_GT(high_value, low_value);
  input({"keydown", "shift"});
  press_and_move(low, high);  // pressed far from the value, which does not jump there
  input({"keyup", "shift"});
  release();
  const double way = high_value - low_value;
  EXPECT_NEAR(value(), high_value + 0.1 * way, 0.02 * way);
}

TEST_F(AppParameters, escape_during_a_drag_brings_the_value_from_before_back) {
  open();
  const std::string key = "combine.threshold";
  const std::string before = parameter(state(), key);
  keys("1");
  const Place from = place("bar:" + key, 0.4), to = place("bar:" + key, 0.9);
  press_and_move(from, to);
  wait_for("the drag", [&](const Json& now) { return parameter(now, key) != before; });
  keys("Escape");
  wait_for("the value", [&](const Json& now) { return parameter(now, key) == before; });
  input({"mousemove", std::to_string(from.x), std::to_string(from.y)});
  release();
  const Json after = settled();
  EXPECT_EQ(parameter(after, key), before) << "the drag is over";
  EXPECT_TRUE(after["steps"].empty());
  EXPECT_EQ(after["view"]["filled"], "normal") << "Esc was for the drag alone";
}

TEST_F(AppParameters, escape_gives_up_what_else_is_dragged) {
  open();
  const auto is_given_up = [&](const char* what, const Place& from, const Place& to) {
    const Json before = settled();
    const auto same = [&](const Json& now) {
      return now["layout"] == before["layout"] && now["parameters"] == before["parameters"] &&
             now["view"]["comparison"] == before["view"]["comparison"];
    };
    press_and_move(from, to);
    wait_for(std::string("the drag of ") + what, [&](const Json& now) { return !same(now); });
    keys("Escape");
    release();
    EXPECT_TRUE(same(settled())) << what;
  };
  const Place edge = place("divider:left");
  is_given_up("a divider", edge, {edge.x + 60, edge.y});
  keys("o");
  is_given_up("the camera", place("tile:final", 0.3), place("tile:final", 0.7));
  keys("v");
  keys("c");
  const Place split = place("split");
  is_given_up("the line between two pictures", split, {split.x + 60, split.y});
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
