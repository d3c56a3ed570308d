// SPDX-License-Identifier: MIT
// Keeping and moving: undo, presets, the session and what is left after a crash, opening and saving files,
// views. All by mouse and keyboard.
#include <fstream>
#include <thread>

#include "tests/app/app_test.h"
#include "tests/cli/command.h"
#include "tests/places.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class AppKeep : public AppTest {
 protected:
  std::string k_normal(const Json& now) const { return parameter(now, "combine.k_normal"); }

  /// Pulls the slider to that share; returns the value it has then.
  std::string pull(double share, size_t steps) {
    drag(place("bar:combine.k_normal", 0.5), place("bar:combine.k_normal", share));
    return k_normal(wait_for("a step", [&](const Json& now) { return now["steps"].size() == steps; }));
  }
  Json wait_for_k(const std::string& value) {
    return wait_for("combine.k_normal = " + value, [&](const Json& now) { return k_normal(now) == value; });
  }

  /// Saves the buffer that is looked at under that name in the test's folder.
  void save_picture(const std::string& name) {
    keys("ctrl+e");
    wait_for("the dialog", [](const Json& now) { return now["ui"].contains("chooser:name"); });
    settled();
    keys("ctrl+a");
    type(name);
    keys("Return");
    wait_for("the file", [&](const Json& now) {
      return !now["log"].empty() && now["log"].back().get<std::string>().ends_with(name);
    });
  }

  fs::path render(const std::string& buffer, const std::string& format) {
    const CommandResult result =
        run_command({inkbench_program(), "render", "--scene", file("scene.toml").string(), "--buffers",
                     buffer, "--format", format, "--out", file("out").string()},
                    {.environment = environment_});
    EXPECT_EQ(result.status, 0) << result.err;
    return file("out") / (buffer + "." + format);
  }

  /// Until the autosave has that value.
  void wait_for_autosave(const std::string& k) const {
    const fs::path autosave = file("config") / "inkbench/windows/1/autosave.toml";
    const auto saved = [&] { return bytes_of(autosave).find("k_normal = " + k + "\n") != std::string::npos; };
    for (int i = 0; i < 500 && !saved(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_TRUE(saved());
  }
};

TEST_F(AppKeep, a_drag_is_one_step_that_undo_takes_back_and_redo_makes_again) {
  open();
  const std::string before = k_normal(state());
  const std::string after = pull(0.2, 1);
  EXPECT_NE(after, before);
  keys("ctrl+z");
  wait_for_k(before);
  keys("ctrl+shift+z");
  wait_for_k(after);
  pull(0.8, 2);
  click("tab:History");
  wait_for("the history", [](const Json& now) { return now["ui"].contains("step:2"); });
  click("step:0");
  EXPECT_EQ(wait_for_k(before)["position"], 0);
  click("step:1");
  wait_for_k(after);
}

TEST_F(AppKeep, undo_of_opening_brings_the_scenes_name_back) {
  open();
  write("other.toml", "base = \"scene.toml\"\n[combine]\nk_normal = 0.5\n");
  const std::string before = k_normal(state());
  open_by_dialog(file("other.toml"));
  EXPECT_EQ(wait_for_k("0.5")["scene"], "other.toml");
  keys("ctrl+z");
  EXPECT_EQ(wait_for_k(before)["scene"], "scene.toml");
}

TEST_F(AppKeep, session_comes_back_at_the_next_start) {
  open();
  const std::string k = pull(0.2, 1);
  keys("ctrl+3");
  wait_for("the bookmark", [](const Json& now) { return now["bookmarks"].size() == 1; });
  click("tab:Cameras");
  wait_for("the tab", [](const Json& now) { return now["layout"]["left_tab"] == "\"views\""; });
  quit();
  open_with({});
  const Json again = state();
  EXPECT_EQ(k_normal(again), k);
  EXPECT_EQ(again["scene"], "scene.toml");
  EXPECT_EQ(again["bookmarks"], Json::parse(R"([["View 3", 3]])"));
  EXPECT_EQ(again["layout"]["left_tab"], "\"views\"");
  EXPECT_EQ(again["unsaved"], 0);
}

TEST_F(AppKeep, work_of_a_killed_window_is_offered_and_restored) {
  open();
  const std::string k = pull(0.2, 1);
  wait_for_autosave(k);
  kill_program();
  open_with({});
  EXPECT_EQ(state()["unsaved"], 1);
  EXPECT_NE(k_normal(state()), k);
  click("restore");
  EXPECT_EQ(wait_for_k(k)["unsaved"], 0);
  quit();
  open_with({});
  EXPECT_EQ(k_normal(state()), k);
  EXPECT_EQ(state()["unsaved"], 0);
}

TEST_F(AppKeep, work_of_a_killed_window_can_be_discarded) {
  open();
  wait_for_autosave(pull(0.2, 1));
  kill_program();
  open_with({});
  const std::string before = k_normal(state());
  click("discard");
  EXPECT_EQ(k_normal(wait_for("an answer", [](const Json& now) { return now["unsaved"] == 0; })), before);
  kill_program();
  open_with({});
  EXPECT_EQ(state()["unsaved"], 0);
}

TEST_F(AppKeep, layout_of_a_killed_window_comes_back_without_a_question) {
  open();
  quit();
  open_with({});
  const Place edge = place("divider:left");
  drag(edge, {edge.x + 60, edge.y});
  const Json before = settled();
  const fs::path autosave = file("config") / "inkbench/windows/1/autosave.toml";
  for (int i = 0; i < 500 && !fs::exists(autosave); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  kill_program();
  open_with({});
  EXPECT_EQ(state()["layout"], before["layout"]);
  EXPECT_EQ(state()["unsaved"], 0);
}

TEST_F(AppKeep, a_preset_is_saved_compared_loaded_and_deleted) {
  open();
  const std::string before = k_normal(state());
  click("tab:Presets");
  wait_for("the panel", [](const Json& now) { return now["ui"].contains("preset:name"); });
  click("preset:name");
  type("one");
  keys("Return");
  const fs::path preset = file("config") / "inkbench/presets/one.toml";
  wait_for("the preset", [](const Json& now) { return now["ui"].contains("preset=one"); });
  EXPECT_TRUE(fs::exists(preset));
  EXPECT_FALSE(settled()["ui"].contains("preset:copy table")) << "nothing differs yet";
  EXPECT_EQ(state()["scene"], "scene.toml");
  click("tab:Parameters");
  wait_for("the parameters", [](const Json& now) { return now["ui"].contains("bar:combine.k_normal"); });
  pull(0.2, 1);
  click("tab:Presets");
  wait_for("a difference", [](const Json& now) { return now["ui"].contains("preset:copy table"); });
  click("preset:load");
  const Json loaded = wait_for_k(before);
  EXPECT_EQ(loaded["scene"], "scene.toml");
  EXPECT_EQ(loaded["steps"].size(), 2U);
  EXPECT_EQ(loaded["steps"].back(), "preset one");
  settled();
  click("preset:delete");
  wait_for("the question", [](const Json& now) { return now["ui"].contains("preset:yes"); });
  EXPECT_TRUE(fs::exists(preset));
  click("preset:yes");
  wait_for("the end of it", [](const Json& now) { return !now["ui"].contains("preset=one"); });
  EXPECT_FALSE(fs::exists(preset));
}

TEST_F(AppKeep, a_preset_is_a_layer_on_the_scene_and_elsewhere_the_same_file_is_a_scene) {
  open();
  const std::string before = k_normal(state());
  const fs::path folder = file("config") / "inkbench/presets";
  fs::create_directories(folder);
  write("other.toml", "# inkbench preset\nbase = \"scene.toml\"\n[combine]\nk_normal = 0.5\n");
  write("config/inkbench/presets/half.toml",
        "# inkbench preset\nbase = \"" + file("scene.toml").string() + "\"\n[combine]\nk_normal = 0.25\n");
  open_by_dialog(folder / "half.toml");
  EXPECT_EQ(wait_for_k("0.25")["scene"], "scene.toml");
  settled();
  click("bar:combine.k_normal", 3);
  wait_for_k(before);
  open_by_dialog(file("other.toml"));
  EXPECT_EQ(wait_for_k("0.5")["scene"], "other.toml");
}

TEST_F(AppKeep, saved_pictures_are_the_files_that_render_writes) {
  open();
  save_picture("a.png");
  EXPECT_TRUE(bytes_of(file("a.png")) == bytes_of(render("final", "png")));
  click("tile:depth_edges");
  wait_for("the choice", [](const Json& now) { return now["view"]["selected"] == "depth_edges"; });
  save_picture("b.exr");
  EXPECT_TRUE(bytes_of(file("b.exr")) == bytes_of(render("depth_edges", "exr")));
}

TEST_F(AppKeep, typed_path_of_a_file_that_is_there_is_asked_about_and_then_replaced) {
  open();
  write("sub/a.png", "kept");
  const fs::path there = file("sub/a.png");
  for (const char* field : {"chooser:name", "path"}) {
    write("sub/a.png", "kept");
    keys("ctrl+e");
    wait_for("the dialog", [](const Json& now) { return now["ui"].contains("chooser:name"); });
    wait_for_text_field();
    click(field);
    keys("ctrl+a");
    type(there.string());
    keys("Return");
    wait_for("the question", [](const Json& now) { return now["ui"].contains("chooser:replace"); });
    EXPECT_EQ(bytes_of(there), "kept");
    click("chooser:ok");
    wait_for("the end", [](const Json& now) { return !now["ui"].contains("chooser:ok"); });
    EXPECT_NE(bytes_of(there), "kept") << field;
  }
  EXPECT_EQ(settled()["log"].back(), "saved final as " + there.string());
}

TEST_F(AppKeep, name_without_an_ending_is_asked_about_with_the_one_that_it_gets) {
  open();
  write("a.png", "kept");
  keys("ctrl+e");
  wait_for("the dialog", [](const Json& now) { return now["ui"].contains("chooser:name"); });
  wait_for_text_field();
  keys("ctrl+a");
  type("a");
  keys("Return");
  wait_for("the question", [](const Json& now) { return now["ui"].contains("chooser:replace"); });
  EXPECT_EQ(bytes_of(file("a.png")), "kept");
}

TEST_F(AppKeep, saving_into_a_mistyped_folder_makes_none_and_says_so) {
  open();
  for (const char* dialog : {"ctrl+e", "ctrl+shift+s"}) {
    keys(dialog);
    wait_for("the dialog", [](const Json& now) { return now["ui"].contains("chooser:name"); });
    wait_for_text_field();
    keys("ctrl+a");
    type((file("piktures") / "a").string());
    keys("Return");
    wait_for("the reason", [](const Json& now) { return now["ui"].contains("chooser:problem"); });
    EXPECT_FALSE(fs::exists(file("piktures")));
    keys("Escape");
    wait_for("the end", [](const Json& now) { return !now["ui"].contains("chooser:ok"); });
  }
}

TEST_F(AppKeep, copied_command_run_by_a_shell_anywhere_draws_the_same_picture) {
  fs::create_directories(file("it's here"));
  fs::create_directories(file("elsewhere"));
  write("it's here/t.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  write("it's here/scene.toml",
        small_scene() + "[[model]]\nname = \"t\"\nshape = \"mesh\"\nmesh = \"t.obj\"\n");
  open_with(
      {"--scene", file("it's here/scene.toml").string(), "--set", "judge.crease=allowed", "--set",
       "ramp.diffuse=[{position = 0, colour = [0.1, 0.2, 0.3], stepped = true}, {position = 0.5, colour "
       "= 1, stepped = false}]",
       "--set", "light.key.direction=[0, 1, 0.5]", "--set", "model.t.material.colour=[1, 0.5, 0]"});
  click("group:mesh");  // room for what is pulled
  pull(0.2, 1);
  save_picture("a.png");
  keys("ctrl+shift+c");
  const std::string start = "copied: ";
  const Json copied = wait_for("the command", [&](const Json& now) {
    return now["log"].back().get<std::string>().starts_with(start);
  });
  const std::string command = copied["log"].back().get<std::string>().substr(start.size());
  const CommandResult result = run_command(
      {"/bin/sh", "-c", command}, {.working_folder = file("elsewhere"), .environment = environment_});
  EXPECT_EQ(result.status, 0) << command << "\n" << result.err;
  EXPECT_TRUE(bytes_of(file("elsewhere/out/render/final.png")) == bytes_of(file("a.png"))) << command;
}

TEST_F(AppKeep, an_exported_picture_brings_its_parameters_back) {
  open();
  const std::string k = pull(0.2, 1);
  save_picture("a.png");
  pull(0.8, 2);
  open_by_dialog(file("a.png"));
  EXPECT_EQ(wait_for_k(k)["recent"][0], file("a.png").string());
}

TEST_F(AppKeep, every_kind_of_file_does_its_own_and_a_bad_one_nothing) {
  open();
  write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  open_by_dialog(file("t.obj"));
  wait_for("the mesh", [&](const Json& now) {
    return parameter(now, "model.ball.mesh").find("t.obj") != std::string::npos;
  });
  write("ramp.toml", "stops = [{position = 0, colour = 1}, {position = 1, colour = [0, 0, 1]}]\n");
  open_by_dialog(file("ramp.toml"));
  wait_for("the ramp", [&](const Json& now) {
    return now["steps"].size() == 2 && now["steps"][1] == "diffuse ramp from ramp.toml";
  });
  write("bad.toml", "[combine]\nk_norml = 1\n");
  const Json before = settled();
  open_by_dialog(file("bad.toml"));
  const Json after = wait_for("the message", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_NE(after["problems"][0].get<std::string>().find("bad.toml:2"), std::string::npos)
      << after["problems"];
  EXPECT_EQ(after["parameters"], before["parameters"]);
  EXPECT_EQ(after["steps"], before["steps"]);
}

TEST_F(AppKeep, a_typed_file_that_is_not_there_is_told_and_its_folder_listed) {
  open();
  write("sub/there.toml", "base = \"../scene.toml\"\n[combine]\nk_normal = 0.5\n");
  keys("ctrl+o");
  wait_for("the dialog", [](const Json& now) { return now["ui"].contains("chooser:ok"); });
  settled();
  type((file("sub") / "their.toml").string());
  keys("Return");
  wait_for("the message", [](const Json& now) {
    return now["ui"].contains("chooser:problem") && now["ui"].contains("entry:there.toml");
  });
  click("path");
  wait_for_text_field();
  keys("End");
  for (int i = 0; i < 7; ++i) keys("BackSpace");
  type("re.toml");
  keys("Return");
  wait_for_k("0.5");
}

TEST_F(AppKeep, views_are_kept_under_digits_and_come_back) {
  open();
  const std::string eye = parameter(state(), "camera.eye");
  keys("ctrl+2");
  wait_for("the bookmark", [](const Json& now) { return now["bookmarks"].size() == 1; });
  keys("Home");
  wait_for("another camera", [&](const Json& now) { return parameter(now, "camera.eye") != eye; });
  keys("shift+2");
  wait_for("the camera", [&](const Json& now) { return parameter(now, "camera.eye") == eye; });
}

TEST_F(AppKeep, wireframe_is_only_looked_at) {
  open();
  const Json before = settled();
  keys("w");
  wait_for("the lines", [](const Json& now) { return now["view"]["wireframe"] == true; });
  const Json after = settled();
  EXPECT_EQ(after["parameters"], before["parameters"]);
  EXPECT_EQ(after["pictures"], before["pictures"]);
  EXPECT_EQ(runs(after, "gbuffer"), runs(before, "gbuffer"));
  EXPECT_EQ(after["problems"], Json::array());
}

}  // namespace
}  // namespace inkbench
