// SPDX-License-Identifier: MIT
// Asking why a pixel is a line: the mark, its keys, and numbers that are those of the picture.
#include "tests/app/app_test.h"

namespace inkbench {
namespace {

class AppWhy : public AppTest {
 protected:
  Json mark(double across, double down) {
    move_to(place("tile:combined_edges", across, down));
    settled();
    xdotool({"click", "1"});
    wait_for("the mark", [](const Json& now) { return !now["why"].is_null(); });
    return settled();
  }
};

TEST_F(AppWhy, click_marks_a_pixel_and_its_sum_is_what_the_gpu_drew) {
  open();
  EXPECT_TRUE(state()["why"].is_null());
  bool line = false;
  bool no_line = false;
  for (const double across : {0.2, 0.3, 0.35, 0.5}) {
    const Json why = mark(across, 0.5)["why"];
    const double sum = why["depth"]["p"].get<double>() + why["normal"]["p"].get<double>();
    EXPECT_NEAR(why["sum"].get<double>(), sum, 1e-6);
    const bool inked = why["inked"].get<bool>();
    EXPECT_NEAR(why["drawn"].get<double>(), inked ? std::min(sum, 1.0) : 0.0, 1e-5) << why;
    EXPECT_EQ(why["text"].get<std::string>().rfind(inked ? "A line" : "No line", 0), 0U) << why["text"];
    (inked ? line : no_line) = true;
  }
  EXPECT_TRUE(no_line);
  // From the middle of the ball outwards there is its outline.
  for (int i = 0; i < 40 && !line; ++i) {
    keys("Left");
    line = settled()["why"]["inked"].get<bool>();
  }
  EXPECT_TRUE(line);
}

TEST_F(AppWhy, a_click_sets_the_value_that_would_draw_the_pixel_and_undo_takes_it_back) {
  open();
  Json before = mark(0.5, 0.5);
  const std::string button = "change:combine.k_normal";
  const auto is_offered = [&] { return before["ui"].contains(button) && before["why"]["inked"] == false; };
  for (int i = 0; i < 20 && !is_offered(); ++i) {
    keys("Left");
    before = settled();
  }
  ASSERT_TRUE(is_offered());
  click(button);
  const Json drawn = wait_for("a line", [](const Json& now) { return now["why"]["inked"] == true; });
  EXPECT_GT(drawn["why"]["drawn"].get<double>(), 0);
  EXPECT_EQ(drawn["steps"].size(), 1U);
  EXPECT_LT(std::stod(parameter(drawn, "combine.k_normal")),
            std::stod(parameter(before, "combine.k_normal")));
  keys("ctrl+z");
  wait_for("none again", [](const Json& now) { return now["why"]["inked"] == false; });
  EXPECT_EQ(parameter(settled(), "combine.k_normal"), parameter(before, "combine.k_normal"));
}

TEST_F(AppWhy, arrow_keys_move_the_mark_and_escape_forgets_it) {
  open();
  const Json marked = mark(0.5, 0.5)["view"]["marked"];
  const int x = marked[0].get<int>();
  const int y = marked[1].get<int>();
  keys("Right");
  keys("Up");
  wait_for("the move", [&](const Json& now) { return now["view"]["marked"] == Json{x + 1, y - 1}; });
  keys("shift+Down");
  const Json moved = wait_for("ten pixels", [&](const Json& now) {
    return now["view"]["marked"] == Json{x + 1, y + 9};
  });
  wait_for("its numbers", [&](const Json& now) { return now["why"]["pixel"] == Json{x + 1, y + 9}; });
  for (int i = 0; i < 10; ++i) keys("shift+Left");
  wait_for("the image's edge", [&](const Json& now) { return now["view"]["marked"] == Json{0, y + 9}; });
  EXPECT_TRUE(settled()["problems"].empty());
  keys("Escape");
  wait_for("no mark", [](const Json& now) { return now["why"].is_null(); });
}

TEST_F(AppWhy, pinned_side_answers_with_the_pinned_states_numbers) {
  open();
  const double before = std::stod(parameter(state(), "combine.k_normal"));
  keys("p");
  drag(place("bar:combine.k_normal", 0.5), place("bar:combine.k_normal", 0.9));
  const Json dragged = wait_for("a step", [](const Json& now) { return now["steps"].size() == 1; });
  const double after = std::stod(parameter(dragged, "combine.k_normal"));
  ASSERT_NE(after, before);
  keys("c");
  const auto ask = [&](double across) {
    const Place at = place("tile:comparison", across);
    input({"mousemove", std::to_string(at.x), std::to_string(at.y), "click", "1"});
    return settled();
  };
  const Json pinned = ask(0.35);
  EXPECT_TRUE(pinned["why"]["pinned"].get<bool>());
  EXPECT_FLOAT_EQ(pinned["why"]["normal"]["k"].get<float>(), static_cast<float>(before));
  const Json now = ask(0.65);
  EXPECT_FALSE(now["why"]["pinned"].get<bool>());
  EXPECT_FLOAT_EQ(now["why"]["normal"]["k"].get<float>(), static_cast<float>(after));
  keys("space");  // shows the pinned one alone at first
  keys("ctrl+shift+c");
  const Json copied = wait_for("the command", [](const Json& state) {
    return state["log"].back().get<std::string>().starts_with("copied: ");
  });
  EXPECT_EQ(copied["log"].back().get<std::string>().find("k_normal"), std::string::npos)
      << "it draws the pinned state";
  const auto k_shown = [&] { return settled()["why"]["normal"]["k"].get<float>(); };
  const float first = k_shown();
  keys("space");
  EXPECT_NE(k_shown(), first) << "the answer is of the picture that is seen";
  keys("c");
  EXPECT_FLOAT_EQ(k_shown(), static_cast<float>(after)) << "no pinned picture is seen";
}

TEST_F(AppWhy, dragging_and_double_clicking_mark_nothing) {
  open();
  drag(place("tile:final", 0.4, 0.4), place("tile:final", 0.6, 0.6));
  EXPECT_TRUE(settled()["why"].is_null());
  move_to(place("tile:final"));
  xdotool({"click", "--repeat", "2", "--delay", "60", "1"});
  wait_for("the large picture", [](const Json& now) { return now["view"]["filled"] == "final"; });
  EXPECT_TRUE(settled()["why"].is_null());
}

TEST_F(AppWhy, dragging_a_mark_of_the_histogram_fixes_what_is_white) {
  open();
  click("tile:normal_edges");
  wait_for("the mark", [](const Json& now) { return !now["why"].is_null(); });
  keys("Escape");  // the buffer stays selected
  wait_for("no mark", [](const Json& now) { return now["why"].is_null(); });
  wait_for("the histogram", [](const Json& now) { return now["ui"].contains("mark:white"); });
  const Json before = settled();
  const Place from = place("mark:white");
  const Place to = place("histogram", 0.9);
  drag({from.x, from.y}, {to.x, from.y});
  wait_for("another picture", [&](const Json& now) {
    return now["pictures"]["normal_edges"] != before["pictures"]["normal_edges"];
  });
  const Json after = settled();
  EXPECT_EQ(after["pictures"]["depth_edges"], before["pictures"]["depth_edges"]);
  EXPECT_EQ(after["parameters"], before["parameters"]) << "files keep the display gains";
  move_to(place("histogram", 0.5));
  xdotool({"click", "--repeat", "2", "--delay", "60", "1"});
  wait_for("the gains again", [&](const Json& now) {
    return now["pictures"]["normal_edges"] == before["pictures"]["normal_edges"];
  });
}

TEST_F(AppWhy, typed_black_and_white_fix_the_range_and_stay_in_order) {
  open();
  click("tile:normal_edges");
  wait_for("the mark", [](const Json& now) { return !now["why"].is_null(); });
  keys("Escape");
  wait_for("the fields",
           [](const Json& now) { return now["why"].is_null() && now["ui"].contains("range:white"); });
  const auto key = [](const Json& now) { return now["pictures"]["normal_edges"].get<std::string>(); };
  std::string last = key(settled());
  for (const auto& [field, text] : {std::pair{"range:white", "0.25"}, {"range:black", "0.5"}}) {
    click(field);
    wait_for_text_field();
    keys("ctrl+a");
    type(text);
    keys("Return");
    last = key(wait_for("another picture", [&](const Json& now) { return key(now) != last; }));
  }
  EXPECT_LT(place("mark:black").x, place("mark:white", 1.0).x) << "white made room";
}

}  // namespace
}  // namespace inkbench
