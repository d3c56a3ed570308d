// SPDX-License-Identifier: MIT
// Curves and strokes in the window: the curve under the mouse, styles, the width drawn by hand.
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

}  // namespace
}  // namespace inkbench
