// SPDX-License-Identifier: MIT
// Painting marks in the window: strokes, undo, the eraser, and that they come back.
#include <chrono>
#include <thread>

#include "pipeline/base/files.h"
#include "tests/app/app_test.h"

namespace inkbench {
namespace {

class AppMarks : public AppTest {
 protected:
  void open_with_brush() {
    open();
    keys("1");
    wait_for("one picture", [](const Json& now) { return now["view"]["filled"] == "normal"; });
    keys("m");
    wait_for("the brush", [](const Json& now) { return now["ui"].contains("brush:Wanted"); });
    settled();  // its tools have moved the picture
  }
  /// A stroke over the ball's outline.
  void paint_across(double down) { drag(place("tile:normal", 0.3, down), place("tile:normal", 0.7, down)); }
  long painted(const Json& now, const char* what) const { return now["painted"][what].get<long>(); }
  void wait_for_autosave() const {
    const std::filesystem::path autosave = file("config") / "inkbench/windows/1/autosave.toml";
    const auto saved = [&] {
      return std::filesystem::exists(autosave) &&
             read_file(autosave).find("[[session.marks]]") != std::string::npos;
    };
    for (int i = 0; i < 500 && !saved(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_TRUE(saved());
  }
  Json wait_for_painted(const char* what) {
    return wait_for(std::string(what) + " marks", [&](const Json& now) { return painted(now, what) > 0; });
  }
};

TEST_F(AppMarks, a_stroke_is_one_step_that_undo_takes_back) {
  open_with_brush();
  const auto steps = state()["steps"].size();
  paint_across(0.5);
  const Json after = wait_for_painted("wanted");
  EXPECT_EQ(after["steps"].size(), steps + 1);
  EXPECT_EQ(after["steps"].back(), "mark as wanted");
  EXPECT_EQ(after["view"]["marked"], nullptr) << "a stroke asks no pixel why";
  keys("ctrl+z");
  wait_for("no marks", [&](const Json& now) { return painted(now, "wanted") == 0; });
  keys("ctrl+y");
  EXPECT_EQ(wait_for_painted("wanted")["painted"], after["painted"]);
}

TEST_F(AppMarks, unwanted_ones_keep_the_lines_under_them) {
  open_with_brush();
  click("brush:Unwanted");
  paint_across(0.5);
  const Json after = wait_for_painted("unwanted");
  EXPECT_GT(painted(after, "drawn"), 0);
  EXPECT_LT(painted(after, "drawn"), painted(after, "unwanted"));
  EXPECT_EQ(painted(after, "wanted"), 0);
}

TEST_F(AppMarks, come_back_at_the_next_start) {
  open_with_brush();
  paint_across(0.4);
  wait_for_painted("wanted");
  click("brush:Unwanted");
  paint_across(0.6);
  const Json before = wait_for_painted("unwanted");
  quit();
  open_with({});
  EXPECT_EQ(state()["painted"], before["painted"]);
}

TEST_F(AppMarks, of_a_killed_window_are_offered_and_restored) {
  open_with_brush();
  paint_across(0.5);
  const Json before = wait_for_painted("wanted");
  wait_for_autosave();
  kill_program();
  open_with({});
  EXPECT_EQ(state()["unsaved"], 1);
  click("restore");
  EXPECT_EQ(wait_for_painted("wanted")["painted"], before["painted"]);
}

TEST_F(AppMarks, go_by_the_eraser_and_with_their_camera) {
  open_with_brush();
  paint_across(0.5);
  const Json before = wait_for_painted("wanted");
  keys("Home");
  wait_for("another camera", [&](const Json& now) { return painted(now, "wanted") == 0; });
  EXPECT_EQ(painted(state(), "cameras"), 1);
  keys("ctrl+z");
  EXPECT_EQ(wait_for_painted("wanted")["painted"], before["painted"]);
  click("brush:Erase");
  paint_across(0.5);
  wait_for("nothing left", [&](const Json& now) { return painted(now, "cameras") == 0; });
}

TEST_F(AppMarks, a_stroke_that_is_given_up_leaves_none) {
  open_with_brush();
  press_and_move(place("tile:normal", 0.3, 0.5), place("tile:normal", 0.7, 0.5));
  keys("Escape");
  settled();  // Esc in a frame before the release
  release();
  const Json after = settled();
  EXPECT_EQ(painted(after, "cameras"), 0);
  EXPECT_EQ(after["view"]["filled"], "normal");
}

TEST_F(AppMarks, alone_are_fitted_without_reference_lines_and_what_they_could_not_have_is_said) {
  open_with_brush();
  drag(place("tile:normal", 0.3, 0.06), place("tile:normal", 0.5, 0.06));  // the empty background
  wait_for_painted("wanted");
  click("brush:Unwanted");
  paint_across(0.5);
  wait_for_painted("unwanted");
  click("tab:Judge");
  click("fit:choices");
  click("fit:reference");
  type_over("bar:fit.budget", "60");
  click("fit");
  const Json found = wait_for("the fit", [](const Json& now) { return now["fit"]["result"].is_object(); });
  EXPECT_EQ(found["fit"]["cameras"], 0) << "the present camera";
  const Json& sentences = found["fit"]["result"]["marks"];
  ASSERT_FALSE(sentences.empty());
  EXPECT_NE(sentences[0].get<std::string>().find("1 of 1 wanted stroke is missed"), std::string::npos)
      << sentences[0];
}

}  // namespace
}  // namespace inkbench
