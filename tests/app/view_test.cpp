// SPDX-License-Identifier: MIT
// Looking: zoom, pan, filling the window, comparing, the camera, resizing, and that looking computes nothing.
#include <cmath>

#include "pipeline/buffers.h"
#include "pipeline/image/image_file.h"
#include "tests/app/app_test.h"
#include "tests/cli/command.h"
#include "tests/places.h"

namespace inkbench {
namespace {

class AppView : public AppTest {
 protected:
  long all_runs(const Json& now) const {
    long sum = 0;
    for (const auto& [name, pass] : now.at("passes").items()) sum += pass.at("runs").get<long>();
    return sum;
  }

  void show_all_buffers() {
    click("buffers");
    click("menu:All");
    wait_for("all buffers", [](const Json& now) {
      return now["layout"]["hidden_buffers"] == "\"\"" && !now["ui"].contains("menu:All");
    });
  }

  /// What the window looks like.
  Picture screenshot() {
    const size_t lines = settled()["log"].size();
    keys("F12");
    const Json saved = wait_for("the screenshot", [&](const Json& now) { return now["log"].size() > lines; });
    const std::string note = saved["log"].back();
    return read_picture(note.substr(note.find('/')), 3);
  }

  /// The scene's picture as the command line draws it.
  Picture rendered(const std::string& buffer, const std::string& assignment) {
    const CommandResult result =
        run_command({inkbench_program(), "render", "--scene", file("scene.toml").string(), "--set",
                     assignment, "--buffers", buffer, "--out", file("out").string()},
                    {.environment = environment_});
    if (result.status != 0) throw std::runtime_error(result.err);
    return read_picture(file("out") / (buffer + ".png"), 3);
  }

  void look_one_to_one() {
    keys("z");
    wait_for("one to one",
             [](const Json& now) { return std::abs(now["view"]["magnification"].get<double>() - 1) < 1e-9; });
  }

  /// Samples of the picture's columns from `first` to before `end` that are others in the middle of the tile,
  /// where it is shown one to one.
  int different_in(const std::string& tile, const Picture& window, const Picture& picture, int first,
                   int end) {
    const auto rect = state()["ui"][tile].get<std::vector<double>>();
    const auto left = std::lround(rect[0] + (rect[2] - rect[0]) / 2 - picture.width_px / 2.0);
    const auto top = std::lround(rect[1] + (rect[3] - rect[1]) / 2 - picture.height_px / 2.0);
    int different = 0;
    for (int y = 0; y < picture.height_px; ++y) {
      for (int x = first; x < end; ++x) {
        for (int c = 0; c < 3; ++c) {
          const int window_x = static_cast<int>(left) + x;
          const int window_y = static_cast<int>(top) + y;
          if (window.at(window_x, window_y, c) != picture.at(x, y, c)) ++different;
        }
      }
    }
    return different;
  }
};

TEST_F(AppView, number_key_fills_the_window_and_escape_goes_back) {
  open();
  keys("5");
  wait_for("the buffer", [](const Json& now) { return now["view"]["filled"] == "combined_edges"; });
  const Json filled = settled();
  EXPECT_TRUE(filled["ui"].contains("tile:combined_edges"));
  EXPECT_FALSE(filled["ui"].contains("tile:final"));
  keys("0");
  wait_for("the last one", [](const Json& now) { return now["view"]["filled"] == "reference"; });
  keys("Escape");
  wait_for("the sheet", [](const Json& now) { return now["ui"].contains("tile:final"); });
}

TEST_F(AppView, keys_leave_pictures_and_tabs_alone_that_are_behind_the_studies) {
  open();
  keys("p");
  keys("ctrl+1");
  keys("Home");
  keys("F3");
  const Json before = settled();
  ASSERT_TRUE(before["studies"]["page_open"].get<bool>());
  for (const char* key : {"1", "c", "space", "z", "w", "l", "o", "j", "p", "Right", "shift+1", "shift+Home"})
    keys(key);
  const Json after = settled();
  for (const char* same : {"view", "layout", "pinned", "parameters", "log"})
    EXPECT_EQ(after[same], before[same]) << same;
  keys("Escape");
  wait_for("the pictures", [](const Json& now) { return !now["studies"]["page_open"].get<bool>(); });
  keys("1");
  wait_for("the large picture", [](const Json& now) { return now["view"]["filled"] == "normal"; });
}

TEST_F(AppView, keys_leave_alone_what_is_behind_the_page_of_keys) {
  open(false);
  const Json before = settled();
  for (const char* key : {"1", "c", "w", "l", "j", "r", "p", "Tab", "F3", "Home", "ctrl+1"}) keys(key);
  const Json after = settled();
  for (const char* same : {"view", "layout", "pinned", "parameters", "studies", "bookmarks"})
    EXPECT_EQ(after[same], before[same]) << same;
  EXPECT_FALSE(after["ui"].contains("close ramps"));
}

TEST_F(AppView, double_click_fills_and_goes_back) {
  open();
  const Place at = place("tile:depth");
  input({"mousemove", std::to_string(at.x), std::to_string(at.y), "click", "--repeat", "2", "--delay", "60",
         "1"});
  wait_for("the buffer", [](const Json& now) { return now["view"]["filled"] == "depth"; });
  settled();
  const Place big = place("tile:depth");
  input({"mousemove", std::to_string(big.x), std::to_string(big.y), "click", "--repeat", "2", "--delay", "60",
         "1"});
  wait_for("the sheet", [](const Json& now) { return now["view"]["filled"] == ""; });
}

TEST_F(AppView, wheel_zooms_and_drag_pans_all_pictures_without_a_pass) {
  open();
  const Place at = place("tile:final", 0.25, 0.25);
  move_to(at);
  const long runs_before = all_runs(settled());
  input({"click", "--repeat", "6", "--delay", "20", "4"});
  wait_for("zoom", [](const Json& now) { return now["view"]["zoom"] > 2.9; });
  const Json zoomed = settled();
  EXPECT_NEAR(zoomed["view"]["zoom"].get<double>(), std::pow(1.2, 6), 1e-6);
  EXPECT_LT(zoomed["view"]["centre"][0].get<double>(), 0.4) << "about the mouse";
  drag(at, {at.x + 30, at.y});
  wait_for("pan", [&](const Json& now) { return now["view"]["centre"][0] < zoomed["view"]["centre"][0]; });
  EXPECT_EQ(all_runs(settled()), runs_before);
}

TEST_F(AppView, alt_drag_turns_the_camera_about_its_target) {
  open();
  const Json before = state();
  const Place at = place("tile:final");
  input({"keydown", "alt"});
  drag(at, {at.x + 24, at.y - 6});
  input({"keyup", "alt"});
  wait_for("the camera",
           [&](const Json& now) { return parameter(now, "camera.eye") != parameter(before, "camera.eye"); });
  const Json after = settled();
  EXPECT_EQ(parameter(after, "camera.target"), parameter(before, "camera.target"));
  EXPECT_NE(after["pictures"]["normal"], before["pictures"]["normal"]);
  EXPECT_NE(after["pictures"]["reference"], before["pictures"]["reference"]);
  EXPECT_EQ(after["steps"].size(), 1U);
  EXPECT_EQ(after["view"]["zoom"], 1.0) << "the view stays";
}

TEST_F(AppView, x_makes_the_camera_orthographic_as_one_step) {
  open();
  const Json before = settled();
  keys("x");
  wait_for("a step", [](const Json& now) { return now["steps"].size() == 1; });
  const Json after = settled();
  EXPECT_EQ(parameter(after, "camera.projection"), "\"orthographic\"");
  EXPECT_NE(after["pictures"]["depth"], before["pictures"]["depth"]);
  EXPECT_NE(after["pictures"]["reference"], before["pictures"]["reference"]);
  keys("ctrl+z");
  wait_for("perspective",
           [&](const Json& now) { return parameter(now, "camera.projection") == "\"perspective\""; });
  EXPECT_EQ(settled()["pictures"]["depth"], before["pictures"]["depth"]);
}

TEST_F(AppView, reference_lines_follow_the_camera_while_it_is_held) {
  open();
  const Json before = state();
  const Place at = place("tile:final");
  input({"keydown", "alt", "mousemove", std::to_string(at.x), std::to_string(at.y), "mousedown", "1",
         "mousemove", std::to_string(at.x + 24), std::to_string(at.y - 6)});
  const Json held = wait_for("other lines", [&](const Json& now) {
    return !now["finds_lines"].get<bool>() && now["pictures"]["reference"] != before["pictures"]["reference"];
  });
  input({"mouseup", "1", "keyup", "alt"});
  EXPECT_EQ(settled()["pictures"]["reference"], held["pictures"]["reference"]);
}

TEST_F(AppView, pinned_state_stays_while_now_changes_and_space_flips) {
  open();
  keys("p");
  wait_for("the pin", [](const Json& now) { return !now["pinned"].empty(); });
  const Json pinned = settled()["pinned"];
  drag(place("bar:combine.k_normal", 0.5), place("bar:combine.k_normal", 0.1));
  wait_for("a step", [](const Json& now) { return now["steps"].size() == 1; });
  keys("c");
  const Json compared =
      wait_for("comparing", [](const Json& now) { return now["view"]["comparison"]["active"]; });
  EXPECT_EQ(compared["view"]["comparison"]["a"], Json({"final", true}));
  EXPECT_EQ(compared["view"]["comparison"]["b"], Json({"final", false}));
  EXPECT_EQ(settled()["pinned"], pinned);
  keys("space");
  wait_for("flipping", [](const Json& now) { return now["view"]["comparison"]["flips"]; });
  const bool shown = settled()["view"]["comparison"]["shows_b"];
  keys("space");
  wait_for("the other", [&](const Json& now) { return now["view"]["comparison"]["shows_b"] != shown; });
}

TEST_F(AppView, every_tile_stays_in_sight_when_the_window_is_resized) {
  open();
  show_all_buffers();
  for (const auto& [width, height] : {std::pair{640, 480}, {1500, 600}, {700, 1000}}) {
    xdotool({"search", "--name", "^inkbench$", "windowsize", std::to_string(width), std::to_string(height)});
    wait_for("the size",
             [w = width](const Json& now) { return now["layout"]["width_px"] == std::to_string(w); });
    const Json ui = settled()["ui"];
    int tiles = 0;
    for (const auto& [name, rect] : ui.items()) {
      if (!name.starts_with("tile:")) continue;
      ++tiles;
      EXPECT_GE(rect[0], 0) << name;
      EXPECT_LE(rect[2], width) << name;
      EXPECT_LE(rect[3], height) << name;
      EXPECT_GT(rect[2].get<double>() - rect[0].get<double>(), 20) << name << " at " << width;
    }
    EXPECT_EQ(tiles, std::ssize(all_buffers()));
  }
}

TEST_F(AppView, window_shows_the_pixels_that_render_writes) {
  open();
  keys("7");
  wait_for("the buffer", [](const Json& now) { return now["view"]["filled"] == "final"; });
  look_one_to_one();
  const Picture window = screenshot();
  const Picture written = rendered("final", "edges.method=paper");
  EXPECT_EQ(different_in("tile:final", window, written, 0, written.width_px), 0);
}

TEST_F(AppView, two_detectors_stand_side_by_side_by_pinning) {
  open();
  click("tile:lines");
  keys("Escape");
  keys("p");
  wait_for("the pin", [](const Json& now) { return !now["pinned"].empty(); });
  choose_method("dihedral");
  keys("c");
  const Json compared =
      wait_for("comparing", [](const Json& now) { return now["view"]["comparison"]["active"]; });
  EXPECT_EQ(compared["view"]["comparison"]["a"], Json({"lines", true}));
  EXPECT_EQ(compared["view"]["comparison"]["b"], Json({"lines", false}));
  look_one_to_one();
  const Picture window = screenshot();
  const Picture paper = rendered("lines", "edges.method=paper");
  const Picture dihedral = rendered("lines", "edges.method=dihedral");
  const int line_between = 8;  // px that it may cover on each side
  const int left = paper.width_px / 2 - line_between;
  const int right = paper.width_px / 2 + line_between;
  EXPECT_EQ(different_in("tile:comparison", window, paper, 0, left), 0) << "pinned";
  EXPECT_EQ(different_in("tile:comparison", window, dihedral, right, dihedral.width_px), 0) << "now";
  EXPECT_GT(different_in("tile:comparison", window, dihedral, 0, left), 0);
  EXPECT_GT(different_in("tile:comparison", window, paper, right, paper.width_px), 0);
}

TEST_F(AppView, picture_that_holds_nothing_says_what_it_lacks) {
  open();
  show_all_buffers();
  const Json paper = settled()["ui"];
  EXPECT_TRUE(paper.contains("lack:pair_angles"));
  EXPECT_TRUE(paper.contains("lack:motion"));
  EXPECT_FALSE(paper.contains("lack:final"));
  choose_method("dihedral");
  const Json dihedral = settled()["ui"];
  EXPECT_FALSE(dihedral.contains("lack:pair_angles"));
  EXPECT_TRUE(dihedral.contains("lack:motion"));
}

TEST_F(AppView, home_shows_the_models_from_within_their_room) {
  open_with({"--set", "image.width=128", "--set", "image.height=128"});
  keys("Home");
  const Json now = wait_for("a step", [](const Json& one) { return one["steps"].size() == 1; });
  const Json eye = Json::parse(parameter(now, "camera.eye"));
  const Json room = Json::parse(parameter(now, "model.room.position"));
  double square = 0;
  for (int i = 0; i < 3; ++i) square += std::pow(eye[i].get<double>() - room[i].get<double>(), 2);
  EXPECT_LT(std::sqrt(square), std::stod(parameter(now, "model.room.size")) / 2);
}

TEST_F(AppView, window_stays_awake_while_a_dense_mesh_gets_its_levels) {
  write("scene.toml", small_scene());
  open_with({"--scene", file("scene.toml").string(), "--set", "model.ball.segments=420"});
  settled();
  type_over("bar:mesh.faces", "300");
  const Json full =
      wait_for("the full mesh", [](const Json& now) { return now["prepares_levels"].get<bool>(); });
  keys("2");  // goes through while the levels are being made
  const Json alive = state();
  EXPECT_EQ(alive["view"]["filled"], "depth");
  EXPECT_TRUE(alive["prepares_levels"].get<bool>());
  EXPECT_EQ(parameter(alive, "mesh.faces"), "300");
  const Json level =
      wait_for("the level", [](const Json& now) { return !now["prepares_levels"].get<bool>(); });
  wait_for("its picture",
           [&](const Json& now) { return now["pictures"]["depth"] != full["pictures"]["depth"]; });
  EXPECT_TRUE(level["problems"].empty()) << level["problems"];
}

TEST_F(AppView, window_closes_while_a_dense_mesh_gets_its_levels) {
  write("scene.toml", small_scene());
  open_with({"--scene", file("scene.toml").string(), "--set", "model.ball.segments=420"});
  settled();
  type_over("bar:mesh.faces", "300");
  wait_for("the full mesh", [](const Json& now) { return now["prepares_levels"].get<bool>(); });
  quit();
}

TEST_F(AppView, large_pictures_come_one_after_the_other_until_all_are_there) {
  open();
  show_all_buffers();
  const Json small = settled();
  write("large.toml", "base = \"scene.toml\"\n[image]\nwidth = 1800\nheight = 1200\n");
  open_by_dialog(file("large.toml"));
  for (const auto& [buffer, key] : small["pictures"].items()) {
    wait_for("the picture of " + buffer, [&](const Json& now) { return now["pictures"][buffer] != key; });
  }
  const Json large = settled();
  EXPECT_EQ(runs(large, "gbuffer"), runs(small, "gbuffer") + 1);
  // Of all but the reference lines, which are drawn beside the window.
  const int drawn = static_cast<int>(small["pictures"].size()) - 1;
  EXPECT_EQ(runs(large, "picture"), runs(small, "picture") + drawn);
}

}  // namespace
}  // namespace inkbench
