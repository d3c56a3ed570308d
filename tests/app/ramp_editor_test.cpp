// SPDX-License-Identifier: MIT
// Editing ramps on the ramp itself.
#include <filesystem>

#include "tests/app/app_test.h"

namespace inkbench {
namespace {

class AppRamps : public AppTest {
 protected:
  const std::string key_ = "ramp.diffuse";

  void open_editor() {
    open();
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
