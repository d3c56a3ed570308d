// SPDX-License-Identifier: MIT
// Fitting parameters to the reference lines from the judge: beside the window, taken over or forgotten.
#include <fstream>

#include "tests/app/app_test.h"

namespace inkbench {
namespace {

class AppFit : public AppTest {
 protected:
  /// A scene whose coefficients draw far too much, at the judge.
  Json open_bad() {
    write("scene.toml", small_scene() + "[combine]\nk_depth = 0.0002\nk_normal = 0.001\n");
    open_with({"--scene", file("scene.toml").string()});
    click("tab:Judge");
    return wait_for("measures", [](const Json& now) { return !now["judge"]["now"].is_null(); });
  }
  Json fitted() {
    click("fit");
    return wait_for("the fit", [](const Json& now) { return now["fit"]["result"].is_object(); });
  }
  /// So many candidates that it does not end by itself.
  void begin_endless() {
    click("fit:choices");
    type_over("bar:fit.budget", "1000000");
    click("fit");
    wait_for("something better", [](const Json& now) {
      return now["fit"].value("state", "") == "running" && now["fit"]["points"] > 1;
    });
  }
  /// Processes that search in this test's folder for temporary files.
  int searches() const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::ifstream stream(entry.path() / "cmdline", std::ios::binary);
      const std::string command{std::istreambuf_iterator<char>(stream), {}};
      const bool is_search = command.find(std::string("\0tune\0", 6)) != std::string::npos;
      if (is_search && command.find(file("tmp").string()) != std::string::npos) ++count;
    }
    return count;
  }
  double f_of(const Json& now) { return now["judge"]["now"]["f1"].get<double>(); }
};

TEST_F(AppFit, improves_f_and_is_taken_over_as_one_step) {
  const Json before = open_bad();
  const Json found = fitted();
  EXPECT_EQ(found["fit"]["state"], "finished");
  const double after = found["fit"]["result"]["after"].get<double>();
  EXPECT_EQ(found["fit"]["result"]["before"].get<double>(), f_of(before)) << "the judge's own F";
  EXPECT_GT(after, f_of(before));
  EXPECT_TRUE(found["steps"].empty()) << "nothing changes before it is taken over";
  click("fit:take over");
  const Json taken = wait_for("the fitted values' measures", [&](const Json& now) {
    return now["steps"].size() == 1 && now["judge"]["behind"] == false && f_of(now) == after;
  });
  for (const char* key : {"combine.k_depth", "combine.k_normal"})
    EXPECT_EQ(parameter(taken, key), found["fit"]["result"]["values"][key]) << key;
  EXPECT_TRUE(settled()["fit"]["result"]["is_set"].get<bool>());
  keys("ctrl+z");
  const Json back = wait_for("the values before", [&](const Json& now) {
    return parameter(now, "combine.k_normal") == parameter(before, "combine.k_normal");
  });
  EXPECT_EQ(parameter(back, "combine.k_depth"), parameter(before, "combine.k_depth"));
}

TEST_F(AppFit, what_is_equally_good_glows_until_another_method_or_clearing) {
  open_bad();
  const Json found = fitted();
  ASSERT_TRUE(found["fit"]["result"].contains("heat"));
  EXPECT_TRUE(found["fit"]["result"]["heat"].contains("combine.k_normal"));
  EXPECT_FALSE(found["fit"]["result"]["heat"].contains("combine.threshold"));
  const auto glows = [](const Json& now) { return now["fit"]["result"].contains("heat"); };
  choose_method("dihedral");
  EXPECT_FALSE(glows(settled()));
  keys("ctrl+z");
  wait_for("the glow again", glows);
  click("fit:discard");
  EXPECT_TRUE(settled()["fit"]["result"].is_null());
  EXPECT_TRUE(state()["steps"].empty() || state()["position"] == 0) << "nothing was changed";
}

TEST_F(AppFit, cancelled_it_keeps_the_best_so_far_and_sliders_work_all_the_while) {
  const Json before = open_bad();
  begin_endless();
  type_over("bar:combine.threshold", "0.9");
  const Json during = wait_for("another value",
                               [&](const Json& now) { return parameter(now, "combine.threshold") == "0.9"; });
  EXPECT_EQ(during["fit"]["state"], "running");
  wait_for("something better",
           [&](const Json& now) { return now["fit"]["best"].get<double>() > f_of(before); });
  click("fit:cancel");
  const Json stopped = wait_for("the end", [](const Json& now) { return now["fit"]["result"].is_object(); });
  EXPECT_EQ(stopped["fit"]["state"], "stopped");
  EXPECT_GT(stopped["fit"]["result"]["after"], f_of(before));
  click("fit:take over");
  wait_for("its values", [&](const Json& now) {
    return parameter(now, "combine.k_normal") == stopped["fit"]["result"]["values"]["combine.k_normal"];
  });
  EXPECT_EQ(parameter(state(), "combine.threshold"), "0.9") << "what was changed meanwhile stays";
  EXPECT_TRUE(state()["problems"].empty());
}

TEST_F(AppFit, moves_what_is_ticked_and_judges_from_the_kept_cameras) {
  open_bad();
  keys("ctrl+1");
  keys("ctrl+2");
  wait_for("two cameras", [](const Json& now) { return now["bookmarks"].size() == 2; });
  click("fit:choices");
  click("fit tick:combine.k_depth");
  wait_for("one tick", [](const Json& now) { return now["fit"]["ticked"] == Json{"combine.k_normal"}; });
  const Json found = fitted();
  EXPECT_EQ(found["fit"]["cameras"], 2);
  EXPECT_EQ(found["fit"]["result"]["values"].size(), 1U);
}

TEST_F(AppFit, closing_the_window_ends_the_search) {
  std::filesystem::create_directories(file("tmp"));
  environment_["TMPDIR"] = file("tmp").string();
  open_bad();
  begin_endless();
  EXPECT_GT(searches(), 0);
  quit();
  EXPECT_EQ(searches(), 0);
  EXPECT_TRUE(std::filesystem::is_empty(file("tmp"))) << "its scratch folder goes with it";
}

}  // namespace
}  // namespace inkbench
