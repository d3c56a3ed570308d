// SPDX-License-Identifier: MIT
// Curves and strokes in the window: the curve under the mouse, styles, the width drawn by hand.
#include <chrono>
#include <thread>

#include "tests/app/app_test.h"

namespace inkbench {
namespace {

class AppCurves : public AppTest {
 protected:
  void fill_with(const std::string& buffer) {
    input({"mousemove", std::to_string(place("tile:" + buffer).x), std::to_string(place("tile:" + buffer).y),
           "click", "--repeat", "2", "--delay", "60", "1"});
    wait_for("one picture", [&](const Json& now) { return now["view"]["filled"] == buffer; });
    settled();
  }
  /// Moves the mouse over the filled picture from its left edge until a curve lies under it.
  Json move_onto_a_curve(const std::string& buffer) {
    for (double across = 0.2; across < 0.6; across += 0.008) {
      move_to(place("tile:" + buffer, across));
      Json now = state();
      if (!now["view"]["curve"].empty()) return now;
    }
    return state();
  }
};

TEST_F(AppCurves, curve_under_the_mouse_is_told_with_its_object_and_not_while_a_button_is_down) {
  open();
  fill_with("curves");
  const Json on = move_onto_a_curve("curves");
  ASSERT_FALSE(on["view"]["curve"].empty());
  EXPECT_EQ(on["view"]["curve"][0], "silhouette of ball");
  EXPECT_EQ(on["view"]["curve"][2], "nothing behind it");
  EXPECT_EQ(on["tooltip"], true);
  input({"mousedown", "1"});
  EXPECT_TRUE(settled()["view"]["curve"].empty());
  release();
}

TEST_F(AppCurves, final_has_curves_under_the_mouse_only_where_strokes_are_drawn) {
  open();
  fill_with("curves");
  ASSERT_FALSE(move_onto_a_curve("curves")["view"]["curve"].empty());
  keys("7");
  const Json filter = wait_for("final", [](const Json& now) { return now["view"]["filled"] == "final"; });
  EXPECT_TRUE(filter["view"]["curve"].empty());
}

TEST_F(AppCurves, strokes_go_on_with_their_paint_while_the_camera_turns_and_are_those_of_files_at_rest) {
  open();
  fill_with("strokes");
  keys("o");
  const Place from = place("tile:strokes", 0.4), to = place("tile:strokes", 0.5);
  press_and_move(from, to);
  const std::string turning = settled()["pictures"]["strokes"];
  release();
  const std::string rest = settled()["pictures"]["strokes"];
  EXPECT_NE(turning, rest);
  keys("ctrl+z");
  const Json undone = wait_for("undo", [&](const Json& now) { return now["pictures"]["strokes"] != rest; });
  EXPECT_EQ(undone["position"], 0);
  keys("ctrl+y");
  wait_for("the same", [&](const Json& now) { return now["pictures"]["strokes"] == rest; });
}

class AppStyles : public AppTest {
 protected:
  const std::string key_ = "stroke.profile";
  const std::string canvas_ = "profile:stroke.profile";

  void open_editor() {
    open();
    keys("t");
    wait_for("the editor", [&](const Json& now) { return now["ui"].contains(canvas_); });
    settled();
  }
  std::string profile() { return parameter(settled(), key_); }
};

TEST_F(AppStyles, button_sets_a_style_in_one_step) {
  open_editor();
  click("style:pencil");
  const Json now =
      wait_for("strokes", [&](const Json& state) { return parameter(state, "ink.from") == "\"strokes\""; });
  EXPECT_EQ(parameter(now, "stroke.brush"), "\"pencil\"");
  EXPECT_EQ(now["steps"].back(), "style pencil");
  keys("ctrl+z");
  wait_for("undo", [&](const Json& state) { return parameter(state, "ink.from") == "\"filter\""; });
  EXPECT_EQ(parameter(state(), "stroke.brush"), "\"solid\"");
}

TEST_F(AppStyles, line_drawn_in_the_canvas_is_the_width_along_strokes_in_one_step) {
  open_editor();
  click("style:technical");
  const Json before = settled();
  drag(place(canvas_, 0.02, 0.9), place(canvas_, 0.98, 0.1));
  const Json after = settled();
  EXPECT_NE(parameter(after, key_), parameter(before, key_));
  EXPECT_NE(after["pictures"]["final"], before["pictures"]["final"]);
  EXPECT_EQ(after["pictures"]["shaded"], before["pictures"]["shaded"]);
  EXPECT_EQ(after["steps"].size(), before["steps"].size() + 1);
  keys("ctrl+z");
  wait_for("undo", [&](const Json& now) { return parameter(now, key_) == parameter(before, key_); });
  EXPECT_EQ(settled()["pictures"]["final"], before["pictures"]["final"]);
}

TEST_F(AppStyles, click_adds_a_point_that_can_be_dragged_and_is_removed_by_a_double_click) {
  open_editor();
  const Place at = place(canvas_, 0.5, 0.5);
  input({"mousemove", std::to_string(at.x), std::to_string(at.y), "click", "1"});
  EXPECT_EQ(profile().find(','), std::string::npos);
  const std::string added = profile();
  EXPECT_NE(added, "\"\"");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // else the next press is a double click
  drag(at, place(canvas_, 0.75, 0.25));
  const std::string moved = profile();
  EXPECT_EQ(moved.find(','), std::string::npos) << "still one point";
  EXPECT_NE(moved, added);
  const Place there = place(canvas_, 0.75, 0.25);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  input({"mousemove", std::to_string(there.x), std::to_string(there.y), "click", "--repeat", "2", "--delay",
         "60", "1"});
  EXPECT_EQ(profile(), "\"\"");
}

TEST_F(AppStyles, escape_gives_up_a_line_that_is_drawn) {
  open_editor();
  press_and_move(place(canvas_, 0.1, 0.5), place(canvas_, 0.9, 0.2));
  wait_for("the drag", [&](const Json& now) { return parameter(now, key_) != "\"\""; });
  keys("Escape");
  wait_for("the profile", [&](const Json& now) { return parameter(now, key_) == "\"\""; });
  release();
  EXPECT_TRUE(settled()["steps"].empty());
}

TEST_F(AppStyles, saved_style_loads_again) {
  open_editor();
  click("style:comic");
  const std::string width = parameter(settled(), "stroke.width");
  const auto answer = [&](const std::string& button) {
    click(button);
    wait_for("the question", [](const Json& now) { return now["ui"].contains("question:path"); });
    wait_for_text_field();
    keys("ctrl+a");
    type(file("mine.toml").string());
    keys("Return");
    wait_for("the answer", [](const Json& now) { return !now["ui"].contains("question:path"); });
    return settled();
  };
  answer("style:save");
  click("style:blueprint");
  ASSERT_NE(parameter(settled(), "stroke.width"), width);
  const Json loaded = answer("style:load");
  EXPECT_EQ(parameter(loaded, "stroke.width"), width);
  EXPECT_EQ(loaded["steps"].back(), "style mine");
}

}  // namespace
}  // namespace inkbench
