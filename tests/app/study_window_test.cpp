// SPDX-License-Identifier: MIT
// Studies from the window: sweeps, grids, running in the background, stopping, what is left behind.
#include <fstream>
#include <thread>

#include "pipeline/image/image_file.h"
#include "tests/app/app_test.h"
#include "tests/cli/command.h"
#include "tests/places.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string text_in(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream stream(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class AppStudy : public AppTest {
 protected:
  void open_small(const std::vector<std::string>& more = {}) {
    std::string scene = small_scene();
    for (const char* side : {"width = 96", "height = 96"}) {
      const size_t at = scene.find(side);
      scene.replace(scene.find("96", at), 2, "48");
    }
    write("scene.toml", scene);
    std::vector<std::string> arguments{"--scene", file("scene.toml").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    open_with(arguments);
  }

  /// A spec of that many cells, a few milliseconds each, opened in the window.
  void open_spec(const std::string& name, int cells) {
    write_spec(name, cells);
    open_by_dialog(name + ".toml");
    wait_for("the spec", [&](const Json& now) {
      return now["studies"]["form"].is_object() &&
             now["studies"]["form"]["spec"] == file(name + ".toml").string();
    });
  }
  void write_spec(const std::string& name, int cells) {
    write(name + ".toml",
          "title = \"" + name + "\"\nscene = \"scene.toml\"\nshow = [\"final\"]\n" +
              "[[axis]]\nkey = \"camera.eye.x\"\nfrom = -1\nto = 1\ncount = " + std::to_string(cells) + "\n");
  }
  void run_spec(const std::string& name, int cells) {
    open_spec(name, cells);
    click("run study");
  }
  fs::path results(const std::string& name) const { return file("data") / "inkbench/studies" / name; }

  /// Presses the key over a parameter's bar.
  void press_over(const std::string& key, const std::string& keys) {
    const Place at = place("bar:" + key);
    input({"mousemove", std::to_string(at.x), std::to_string(at.y), "key", keys});
  }
  Json wait_for_axes(size_t count) {
    return wait_for("the axes", [&](const Json& now) {
      const Json& form = now["studies"]["form"];
      return form.is_object() && form["axes"].size() == count && form["cells"] > 0;
    })["studies"]["form"];
  }
  void fill_in(const std::string& field, const std::string& text) {
    click(field);
    wait_for_text_field();
    keys("ctrl+a");
    type(text);
    keys("Return");
  }

  static Json study_in(const Json& now, const std::string& name) {
    for (const Json& study : now.at("studies").at("list")) {
      if (study.at("name") == name) return study;
    }
    return nullptr;
  }
  Json wait_for_study(const std::string& name, const std::string& state) {
    return study_in(wait_for(name + " " + state,
                             [&](const Json& now) {
                               const Json study = study_in(now, name);
                               return study.is_object() && study["state"] == state;
                             }),
                    name);
  }
  /// Until some of its cells are there.
  Json wait_for_cells(const std::string& name) {
    return wait_for("cells of " + name, [&](const Json& now) {
      const Json study = study_in(now, name);
      return study.is_object() && study["state"] == "running" && study.value("drawn", 0) >= 5;
    });
  }

  /// The command line of a process; empty where it has ended meanwhile.
  static std::string command_of(const fs::path& process) {
    try {
      return text_in(process / "cmdline");
    } catch (const std::exception&) {
      return "";
    }
  }

  /// Processes that run a study of this test.
  std::vector<int> study_processes() const {
    std::vector<int> found;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      const std::string name = entry.path().filename().string();
      if (name.find_first_not_of("0123456789") != std::string::npos) continue;
      const std::string command = command_of(entry.path());
      const bool is_study = command.find(std::string("\0study\0", 7)) != std::string::npos;
      if (is_study && command.find(file("").string()) != std::string::npos) found.push_back(std::stoi(name));
    }
    return found;
  }
  bool no_study_runs_within(double seconds) const {
    const auto start = Clock::now();
    while (!study_processes().empty()) {
      if (Clock::now() - start > std::chrono::duration<double>(seconds)) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
  }

  /// `inkbench study` by hand; the last progress that it tells.
  Json run_by_hand(const fs::path& spec, const fs::path& out) {
    const CommandResult result =
        run_command({inkbench_program(), "study", spec.string(), "--out", out.string(), "--progress", "json"},
                    {.environment = environment_});
    EXPECT_EQ(result.status, 0) << result.err;
    const size_t at = result.out.rfind("{\"done\"");
    if (at == std::string::npos) return nullptr;
    return Json::parse(result.out.substr(at, result.out.find('\n', at) - at));
  }
};

TEST_F(AppStudy, charts_of_a_finished_study_are_shown) {
  open_small();
  write("lines.toml",
        "title = \"lines\"\nscene = \"scene.toml\"\nshow = [\"final\"]\n"
        "[[axis]]\nkey = \"combine.k_normal\"\nvalues = [0.01, 0.1, 0.4]\n"
        "[[chart]]\nname = \"ink\"\ntitle = \"Ink\"\nx = \"combine.k_normal\"\ny = \"ink\"\n");
  open_by_dialog("lines.toml");
  wait_for("the spec", [&](const Json& now) { return now["studies"]["form"].is_object(); });
  click("run study");
  wait_for_study("lines", "finished");
  click("show charts");
  place("chart:ink");  // once it rests
  settled();
  keys("F12");
  const Json saved = wait_for("the screenshot", [](const Json& now) {
    return !now["log"].empty() && now["log"].back().get<std::string>().starts_with("saved ");
  });
  const std::string note = saved["log"].back();
  const Picture window = read_picture(note.substr(note.find('/')), 3);
  const auto rect = saved["ui"]["chart:ink"].get<std::vector<double>>();
  EXPECT_GT(rect[2] - rect[0], 300) << "as wide as the room";
  int white = 0, inked = 0;
  const int bottom = std::min(static_cast<int>(rect[3]), window.height_px);
  for (int y = static_cast<int>(rect[1]) + 2; y < bottom - 2; ++y) {
    for (int x = static_cast<int>(rect[0]) + 2; x < static_cast<int>(rect[2]) - 2; ++x)
      ++(window.at(x, y, 0) > 240 && window.at(x, y, 2) > 240 ? white : inked);
  }
  EXPECT_GT(white, 4 * inked) << "paper";
  EXPECT_GT(inked, 300) << "axes, text and a curve";
  fs::remove(results("lines") / "charts/ink.png");
  click("show grid");
  click("show charts");
  wait_for("the missing chart", [](const Json& now) { return !now["ui"].contains("chart:ink"); });
  click("show grid");
  wait_for("the cells", [](const Json& now) { return now["ui"].contains("cell:1"); });
}

TEST_F(AppStudy, sweep_is_saved_as_a_spec_that_the_command_line_runs_unchanged) {
  open_small();
  press_over("combine.k_depth", "s");
  const Json form = wait_for_axes(1);
  EXPECT_TRUE(state()["studies"]["page_open"]);
  EXPECT_EQ(form["axes"][0]["key"], "combine.k_depth");
  EXPECT_EQ(form["axes"][0]["count"], 5);
  EXPECT_EQ(form["axes"][0]["from"], 0.00075);
  EXPECT_EQ(form["axes"][0]["to"], 0.012);
  type_over("axis 0 count", "3");
  wait_for("the count", [](const Json& now) { return now["studies"]["form"]["cells"] == 3; });
  input({"click", "--repeat", "30", "--delay", "20",
         "5"});  // the mouse wheel: the page is longer than the window
  fill_in("study Folder", file("specs").string());
  wait_for("the reason", [](const Json& now) { return now["studies"]["form"]["problem"] != ""; });
  click("run study");
  EXPECT_FALSE(fs::exists(file("specs"))) << "a mistyped folder is not made";
  fs::create_directories(file("specs"));
  input({"click", "--repeat", "30", "--delay", "20",
         "4"});  // the mouse wheel: the page is longer than the window
  fill_in("study Name", "mine");
  const fs::path spec = file("specs") / "mine.toml";
  wait_for("the name", [&](const Json& now) { return now["studies"]["form"]["spec"] == spec.string(); });
  click("save spec");
  wait_for("the file", [](const Json& now) { return now["studies"]["form"]["saved"] == true; });
  const std::string text = text_in(spec);
  EXPECT_NE(text.find("scene = \"" + file("scene.toml").string() + "\""), std::string::npos) << text;
  EXPECT_FALSE(fs::exists(file("specs") / "mine_scene.toml"))
      << "the scene that is open is named, not copied";
  EXPECT_EQ(run_by_hand(spec, file("out"))["done"], 3);
  EXPECT_EQ(text_in(spec), text);
  const std::vector<std::string> rows = lines_of(file("out") / "data.csv");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].rfind("1,0.00075,", 0), 0U) << rows[1];
  EXPECT_EQ(rows[3].rfind("3,0.012,", 0), 0U) << rows[3];
}

TEST_F(AppStudy, menu_of_a_parameter_sweeps_it_and_adds_another_axis) {
  open_small();
  click("name:combine.k_depth", 3);
  click("sweep:combine.k_depth");
  EXPECT_EQ(wait_for_axes(1)["axes"][0]["key"], "combine.k_depth");
  click("name:combine.k_normal", 3);
  click("grid:combine.k_normal");
  const Json form = wait_for_axes(2);
  EXPECT_EQ(form["axes"][1]["key"], "combine.k_normal");
  EXPECT_EQ(form["cells"], 25);
}

TEST_F(AppStudy, a_cell_is_taken_over_as_one_step_that_undo_takes_back) {
  open_small();
  const Json before = settled()["parameters"];
  press_over("combine.k_depth", "s");
  wait_for_axes(1);
  type_over("axis 0 count", "4");
  click("size 1:2");
  wait_for("the form", [](const Json& now) {
    return now["studies"]["form"]["cells"] == 4 && now["studies"]["form"]["size"] == Json{24, 24};
  });
  click("run study");
  EXPECT_EQ(wait_for_study("k_depth", "finished")["done"], 4);
  wait_for("the grid", [](const Json& now) { return now["studies"]["cells"] == 4; });
  EXPECT_EQ(settled()["studies"]["shown"], "k_depth");
  EXPECT_EQ(state()["parameters"], before) << "running a study changes nothing";
  click("cell:4");
  const Json taken = wait_for("the step", [](const Json& now) { return now["steps"].size() == 1; });
  EXPECT_EQ(parameter(taken, "combine.k_depth"), "0.012");
  EXPECT_EQ(parameter(taken, "image.width"), "24");
  EXPECT_EQ(parameter(taken, "image.height"), "24");
  EXPECT_TRUE(taken["steps"][0].get<std::string>().ends_with(", 24 × 24 px")) << taken["steps"];
  EXPECT_TRUE(taken["log"].back().get<std::string>().ends_with(", 24 × 24 px")) << taken["log"];
  keys("ctrl+z");
  EXPECT_EQ(wait_for("undo", [](const Json& now) { return now["position"] == 0; })["parameters"], before);
  EXPECT_EQ(settled()["problems"], Json::array());
}

TEST_F(AppStudy, shift_s_makes_a_grid_of_two) {
  open_small();
  press_over("combine.k_depth", "s");
  wait_for_axes(1);
  press_over("combine.k_normal", "shift+s");
  EXPECT_EQ(wait_for_axes(2)["axes"][1]["key"], "combine.k_normal");
  type_over("axis 0 count", "3");
  type_over("axis 1 count", "2");
  wait_for("the counts", [](const Json& now) { return now["studies"]["form"]["cells"] == 6; });
  click("run study");
  EXPECT_EQ(wait_for_study("k_depth_k_normal", "finished")["done"], 6);
  const Json ui = wait_for("the grid", [](const Json& now) { return now["ui"].contains("cell:6"); })["ui"];
  EXPECT_EQ(ui["cell:1"][1], ui["cell:3"][1]) << "three in a row";
  EXPECT_EQ(ui["cell:1"][0], ui["cell:4"][0]) << "two in a column";
  EXPECT_LT(ui["cell:3"][1], ui["cell:4"][1]);
}

TEST_F(AppStudy, fast_keys_mean_the_parameter_and_the_modifiers_of_their_press) {
  open_small();
  const Place a = place("bar:combine.k_depth"), b = place("bar:combine.k_normal");
  const auto text = [](int number) { return std::to_string(number); };
  for (int i = 0; i < 12; ++i) {
    // The second Shift may come within the millisecond of the first, and the mouse leaves before the keys
    // end.
    input({"mousemove", text(a.x), text(a.y), "key", "s"});
    input({"mousemove", text(b.x), text(b.y), "key",     "--delay", "0",    "shift+x", "keydown",
           "--delay",   "0",       "shift",   "keydown", "--delay", "0",    "s",       "mousemove",
           text(a.x),   text(a.y), "keyup",   "s",       "keyup",   "shift"});
    const Json axes = state()["studies"]["form"]["axes"];
    ASSERT_EQ(axes.size(), 2U) << axes;
    EXPECT_EQ(axes[0]["key"], "combine.k_depth");
    EXPECT_EQ(axes[1]["key"], "combine.k_normal");
  }
}

TEST_F(AppStudy, a_stopped_study_is_continued) {
  open_small();
  run_spec("long", 3000);
  wait_for_cells("long");
  click("study action");
  const Json stopped = wait_for_study("long", "stopped");
  EXPECT_TRUE(study_processes().empty());
  const long done = stopped["done"].get<long>();
  EXPECT_GE(done, 5);
  EXPECT_LT(done, 3000);
  EXPECT_EQ(state()["problems"], Json::array());
  click("study action");
  const Json again = study_in(wait_for_cells("long"), "long");
  EXPECT_EQ(again["done"].get<long>() - again["drawn"].get<long>(), done) << "what was there stays";
}

TEST_F(AppStudy, closing_the_window_ends_its_study_which_can_be_continued) {
  open_small();
  run_spec("long", 700);
  wait_for_cells("long");
  quit();
  EXPECT_TRUE(study_processes().empty());
  EXPECT_EQ(Json::parse(text_in(results("long") / "manifest.json"))["state"], "stopped");
  const Json progress = run_by_hand(file("long.toml"), results("long"));
  EXPECT_EQ(progress["done"], 700);
  EXPECT_LT(progress["drawn"], 700) << "it goes on where it was";
  EXPECT_EQ(lines_of(results("long") / "data.csv").size(), 701U);
}

TEST_F(AppStudy, study_of_a_killed_window_ends_too_and_can_be_continued) {
  open_small();
  run_spec("long", 700);
  wait_for_cells("long");
  ASSERT_EQ(study_processes().size(), 1U);
  kill_program();
  EXPECT_TRUE(no_study_runs_within(5));
  open_with({});
  const Json listed = study_in(state(), "long");
  EXPECT_EQ(listed["state"], "stopped");
  EXPECT_EQ(listed["total"], 700);
  const Json progress = run_by_hand(file("long.toml"), results("long"));
  EXPECT_EQ(progress["done"], 700);
  EXPECT_LT(progress["drawn"], 700);
}

TEST_F(AppStudy, studies_run_one_after_the_other_and_a_broken_one_is_told) {
  open_small();
  run_spec("one", 4000);
  run_spec("two", 3);
  run_spec("three", 3);
  run_spec("four", 3);
  const Json queued = wait_for_cells("one");
  for (const char* name : {"two", "three", "four"})
    EXPECT_EQ(study_in(queued, name)["state"], "waiting") << name;
  EXPECT_EQ(study_processes().size(), 1U);
  write("two.toml",
        "title = \"two\"\nscene = \"scene.toml\"\n[[axis]]\nkey = \"camera.eey.x\"\nvalues = [1]\n");
  click("study:one");
  wait_for("its grid", [](const Json& now) { return now["studies"]["shown"] == "one"; });
  click("study action");
  bool early = false;
  wait_for("the last one", [&](const Json& now) {
    EXPECT_LE(study_processes().size(), 1U);
    const bool three_is_over = study_in(now, "three")["state"] == "finished";
    early |= !three_is_over && study_in(now, "four")["state"] != "waiting";
    return study_in(now, "four")["state"] == "finished";
  });
  EXPECT_FALSE(early);
  const Json over = settled();
  EXPECT_EQ(study_in(over, "one")["state"], "stopped");
  EXPECT_EQ(study_in(over, "two")["state"], "failed");
  EXPECT_EQ(study_in(over, "three")["state"], "finished");
  EXPECT_NE(study_in(over, "two")["problem"].get<std::string>().find("two.toml:4"), std::string::npos)
      << study_in(over, "two");
  EXPECT_NE(over["log"].dump().find("two.toml:4"), std::string::npos) << over["log"];
}

TEST_F(AppStudy, study_that_another_window_ran_meanwhile_stays_in_the_list) {
  open_small();
  write("config/inkbench/studies.toml",
        "[[study]]\ntitle = \"theirs\"\nspec = \"/theirs.toml\"\nfolder = \"/out/theirs\"\n");
  run_spec("ours", 2);
  const Json now =
      wait_for("the end", [&](const Json& state) { return study_in(state, "ours")["state"] == "finished"; });
  EXPECT_EQ(study_in(now, "theirs")["state"], "stopped");
  quit();
  open_with({});
  EXPECT_EQ(state()["studies"]["list"].size(), 2U);
}

TEST_F(AppStudy, menu_opens_the_spec_whose_name_is_typed) {
  open_small();
  write_spec("typed", 2);
  click("menu:Studies");
  click("menu:Open a spec or results...");
  wait_for("the question", [](const Json& now) { return now["ui"].contains("question:path"); });
  wait_for_text_field();
  type(file("typed.toml").string());
  keys("Return");
  wait_for("the form", [](const Json& now) {
    const Json& form = now["studies"]["form"];
    return form.is_object() && form["cells"] == 2;
  });
}

TEST_F(AppStudy, broken_spec_is_told_and_cannot_be_run) {
  open_small();
  write("bad.toml", "title = \"bad\"\n[[axis]]\nkey = \"camera.eey.x\"\nvalues = [1]\n");
  open_by_dialog("bad.toml");
  const Json told = wait_for("the message", [](const Json& now) { return !now["problems"].empty(); });
  EXPECT_NE(first_problem(told).find("bad.toml:3"), std::string::npos) << told["problems"];
  open_spec("good", 2);
  click("spec text");
  wait_for_text_field();
  type("x");
  const Json wrong =
      wait_for("the problem", [](const Json& now) { return now["studies"]["form"]["problem"] != ""; });
  EXPECT_EQ(wrong["studies"]["form"]["cells"], 0);
  click("run study");
  EXPECT_EQ(settled()["studies"]["list"], Json::array());
  EXPECT_TRUE(study_processes().empty());
}

TEST_F(AppStudy, page_draws_no_more_frames_than_progress_needs_and_none_when_idle) {
  open_small();
  run_spec("long", 4000);
  wait_for_cells("long");
  input({"mousemove", "5", "715"});
  const auto pause = std::chrono::milliseconds(1500);
  const Json first = wait_for_cells("long");
  const auto start = Clock::now();
  std::this_thread::sleep_for(pause);
  const Json last = wait_for_cells("long");
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const long frames = last["frames"].get<long>() - first["frames"].get<long>();
  EXPECT_GT(frames, 1);
  EXPECT_LT(static_cast<double>(frames), 10 * seconds + 1);
  EXPECT_GT(study_in(last, "long")["done"], study_in(first, "long")["done"]);
  click("study action");
  wait_for_study("long", "stopped");
  input({"mousemove", "5", "715"});
  const long rest = settled()["frames"];
  std::this_thread::sleep_for(pause);
  EXPECT_EQ(settled()["frames"], rest) << "with the grid";
  click("new study");
  input({"mousemove", "5", "715"});
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  const long form = settled()["frames"];
  std::this_thread::sleep_for(pause);
  EXPECT_EQ(settled()["frames"], form) << "with the form";
}

TEST_F(AppStudy, notes_of_cells_are_no_errors) {
  write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  write("t.toml", "[[model]]\nname = \"t\"\nshape = \"mesh\"\nmesh = \"t.obj\"\n");
  write("s.toml",
        "title = \"noted\"\nscene = \"t.toml\"\nshow = [\"depth\"]\n[set]\nimage = {width = 16, height = "
        "16}\n[[axis]]\nkey = \"mesh.faces\"\nvalues = [1000, 2000]\n");
  open_small();
  open_by_dialog(file("s.toml"));
  wait_for("the spec", [](const Json& now) { return now["studies"]["form"]["cells"] == 2; });
  click("run study");
  wait_for_study("s", "finished");
  const Json after = settled();
  EXPECT_EQ(after["errors"], Json::array());
  const std::string log = after["log"].dump();
  EXPECT_NE(log.find("1,000 faces asked"), std::string::npos) << log;
}

}  // namespace
}  // namespace inkbench
