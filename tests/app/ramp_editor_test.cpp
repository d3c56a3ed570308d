// SPDX-License-Identifier: MIT
// Editing ramps on the ramp itself.
#include <cmath>
#include <filesystem>
#include <set>

#include "tests/app/app_test.h"

namespace inkbench {
namespace {

class AppRamps : public AppTest {
 protected:
  const std::string key_ = "ramp.diffuse";

  void open_editor() {
    open();
    click("group:ramp");
    click("strip:" + key_);
    wait_for("the editor", [&](const Json& now) { return now["ui"].contains("ramp:" + key_); });
    settled();
  }

  std::string ramp() { return parameter(settled(), key_); }

  static size_t stops_of(const std::string& text) {
    size_t count = 0;
    for (size_t at = 0; (at = text.find("position", at)) != std::string::npos; ++at) ++count;
    return count;
  }

  Json wait_for_stops(size_t count) {
    return wait_for(std::to_string(count) + " stops",
                    [&](const Json& now) { return stops_of(parameter(now, key_)) == count; });
  }
};

TEST_F(AppRamps, bands_that_are_no_finite_number_change_nothing) {
  open_editor();
  const std::string before = ramp();
  for (const char* text : {"nan", "inf", "many"}) {
    type_over("bands:" + key_, text);
    EXPECT_EQ(ramp(), before) << text;
  }
  type_over("bands:" + key_, "6");
  wait_for_stops(6);
}

TEST_F(AppRamps, stop_dragged_on_the_ramp_changes_the_shading_in_one_step) {
  open_editor();
  const Json before = state();
  const std::string ramp_before = ramp();
  const size_t steps = before["steps"].size();
  drag(place("ramp:" + key_, 0.45), place("ramp:" + key_, 0.6));
  wait_for("the ramp", [&](const Json& now) { return parameter(now, key_) != ramp_before; });
  const Json after = settled();
  EXPECT_EQ(stops_of(parameter(after, key_)), 4U);
  EXPECT_NE(after["pictures"]["shaded"], before["pictures"]["shaded"]);
  EXPECT_EQ(after["pictures"]["combined_edges"], before["pictures"]["combined_edges"]);
  EXPECT_EQ(after["steps"].size(), steps + 1) << "a drag is one step";
  keys("ctrl+z");
  wait_for("undo", [&](const Json& now) { return parameter(now, key_) == ramp_before; });
}

TEST_F(AppRamps, press_adds_a_stop_with_the_colour_there_and_delete_removes_it) {
  open_editor();
  const Json before = state();
  const std::string ramp_before = ramp();
  click("ramp:" + key_);  // in its middle, where no stop is
  wait_for_stops(5);
  EXPECT_EQ(settled()["passes"]["gbuffer"]["runs"], before["passes"]["gbuffer"]["runs"]);
  keys("Delete");
  wait_for_stops(4);
  EXPECT_EQ(ramp(), ramp_before);
}

TEST_F(AppRamps, stop_dragged_away_is_removed_and_one_dragged_back_is_not) {
  open_editor();
  const std::string before = ramp();
  const Place stop = place("ramp:" + key_, 0.8);
  xdotool({"mousemove", std::to_string(stop.x), std::to_string(stop.y), "mousedown", "1"});
  xdotool({"mousemove", std::to_string(stop.x), std::to_string(stop.y - 120)});
  wait_for_stops(3);
  xdotool({"mousemove", std::to_string(stop.x), std::to_string(stop.y)});
  wait_for_stops(4);
  xdotool({"mousemove", std::to_string(stop.x), std::to_string(stop.y - 120)});
  wait_for_stops(3);
  xdotool({"mouseup", "1"});
  EXPECT_EQ(stops_of(ramp()), 3U);
  keys("ctrl+z");
  wait_for("undo", [&](const Json& now) { return parameter(now, key_) == before; });
}

TEST_F(AppRamps, even_bands_have_as_many_colours) {
  open_editor();
  type_over("bands:" + key_, "9");
  wait_for_stops(9);
  const std::string text = ramp();
  std::set<std::string> colours;
  for (size_t at = 0; (at = text.find("colour = ", at)) != std::string::npos; ++at)
    colours.insert(text.substr(at, text.find("stepped", at) - at));
  EXPECT_EQ(colours.size(), 9U) << text;
}

TEST_F(AppRamps, escape_gives_up_a_stop_that_is_dragged_or_was_just_added) {
  open_editor();
  const std::string before = ramp();
  for (const double from : {0.45, 0.5}) {  // where there is one, and where there is none
    press_and_move(place("ramp:" + key_, from), place("ramp:" + key_, 0.65));
    wait_for("the drag", [&](const Json& now) { return parameter(now, key_) != before; });
    keys("Escape");
    wait_for("the ramp", [&](const Json& now) { return parameter(now, key_) == before; });
    release();
    EXPECT_EQ(ramp(), before);
  }
  EXPECT_TRUE(state()["steps"].empty());
  EXPECT_TRUE(state()["ui"].contains("ramp:" + key_)) << "the editor stays";
}

TEST_F(AppRamps, shift_moves_a_stop_a_tenth_as_far) {
  open_editor();
  const Place stop = place("ramp:" + key_, 0.8);
  const Place to{stop.x + 100, stop.y};
  const auto last = [&](const Json& now) {
    const std::string text = parameter(now, key_);
    return std::stod(text.substr(text.rfind("position = ") + 11));
  };
  const double before = last(settled());
  input({"keydown", "shift"});
  press_and_move(stop, to);
  input({"keyup", "shift"});
  release();
  const double fine = last(settled()) - before;
  keys("ctrl+z");
  wait_for("undo", [&](const Json& now) { return last(now) == before; });
  press_and_move(stop, to);
  release();
  EXPECT_NEAR(fine, 0.1 * (last(settled()) - before), 0.005);
  EXPECT_GT(fine, 0);
}

TEST_F(AppRamps, colour_that_is_dragged_is_finer_with_shift_and_given_up_by_escape) {
  open_editor();
  const std::string before = ramp();
  click("stop colour:" + key_);
  const Place from = place("stop picker:" + key_, 0.3, 0.3), to = place("stop picker:" + key_, 0.6, 0.3);
  const auto green = [&](const Json& now) {  // of the first stop
    const std::string text = parameter(now, key_);
    return std::stod(text.substr(text.find(',', text.find("colour = [")) + 1));
  };
  input({"keydown", "shift"});
  input({"mousemove", std::to_string(from.x), std::to_string(from.y)});
  input({"mousedown", "1"});
  const Json pressed = settled();
  input({"mousemove", std::to_string(to.x), std::to_string(to.y)});
  const Json fine = settled();
  keys("shift+Escape");
  wait_for("the ramp", [&](const Json& now) { return parameter(now, key_) == before; });
  release();
  input({"keyup", "shift"});
  EXPECT_TRUE(state()["ui"].contains("stop picker:" + key_)) << "the picker stays";
  press_and_move(from, to);
  const Json plain = settled();
  keys("Escape");
  release();
  EXPECT_EQ(ramp(), before);
  const double way = std::abs(green(plain) - green(pressed));
  EXPECT_GT(way, 0.05);
  EXPECT_NEAR(std::abs(green(fine) - green(pressed)), 0.1 * way, 0.04 * way);
}

TEST_F(AppRamps, what_is_typed_into_a_slow_window_goes_into_the_question_that_a_click_asked) {
  open_editor();
  const Place at = place("save:" + key_);
  while_it_stands_still([&] {
    xdotool({"mousemove", std::to_string(at.x), std::to_string(at.y), "click", "1", "type", "--delay", "0",
             file("1.toml").string()});
  });
  keys("Return");
  wait_for("the end", [](const Json& now) { return !now["ui"].contains("question:path"); });
  EXPECT_TRUE(std::filesystem::exists(file("1.toml"))) << settled()["problems"];
  EXPECT_EQ(state()["view"]["filled"], "");
}

TEST_F(AppRamps, saving_asks_before_it_replaces_and_makes_no_folder) {
  open_editor();
  write("there.toml", "kept");
  const auto save_as = [&](const std::string& name) {
    click("question:path");
    keys("ctrl+a");
    type(file(name).string());
    keys("Return");
  };
  click("save:" + key_);
  wait_for("the question", [](const Json& now) { return now["ui"].contains("question:path"); });
  wait_for_text_field();
  save_as("their/ramp.toml");
  wait_for("the reason", [](const Json& now) { return now["ui"].contains("question:problem"); });
  EXPECT_FALSE(std::filesystem::exists(file("their")));
  save_as("there.toml");
  wait_for("the question", [](const Json& now) { return now["ui"].contains("question:replace"); });
  EXPECT_EQ(std::filesystem::file_size(file("there.toml")), 4U);
  click("question:accept");
  wait_for("the end", [](const Json& now) { return !now["ui"].contains("question:path"); });
  EXPECT_GT(std::filesystem::file_size(file("there.toml")), 4U);
}

TEST_F(AppRamps, saved_ramp_loads_again_and_an_image_turns_into_stops) {
  open_editor();
  const std::string before = ramp();
  const auto answer = [&](const std::string& button, const std::string& name) {
    click(button + ":" + key_);
    wait_for("the question", [](const Json& now) { return now["ui"].contains("question:path"); });
    wait_for_text_field();
    keys("ctrl+a");
    type(file(name).string());
    keys("Return");
    wait_for("the answer", [](const Json& now) { return !now["ui"].contains("question:path"); });
    settled();
  };
  answer("save", "ramp.png");
  answer("save", "ramp.toml");
  EXPECT_TRUE(std::filesystem::exists(file("ramp.png")) && std::filesystem::exists(file("ramp.toml")));
  answer("load", "ramp.png");
  EXPECT_NE(ramp().find("ramp.png"), std::string::npos);
  click("to stops:" + key_);
  wait_for_stops(4);
  answer("load", "ramp.toml");
  wait_for("the same ramp", [&](const Json& now) { return parameter(now, key_) == before; });
  answer("load", "nothing.toml");
  const Json told = wait_for("a problem", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_EQ(parameter(told, key_), before);
}

}  // namespace
}  // namespace inkbench
