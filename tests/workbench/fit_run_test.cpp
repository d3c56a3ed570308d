// SPDX-License-Identifier: MIT
// A search beside the window, with a script in the place of the program: progress, its result, stopping.
#include "app/workbench/fit_run.h"

#include <chrono>
#include <functional>
#include <thread>

#include "pipeline/base/files.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kTuning = R"({
  "default": {"objective": 0.5, "values": {"combine.k_depth": "0.003", "dihedral.normals": "\"surface\""}},
  "tuned": {"objective": 0.9, "values": {"combine.k_depth": "0.01", "dihedral.normals": "\"both\""}},
  "leave_one_out": {"objective": 0.7, "limits_kept": true},
  "gained": false,
  "parameters": [
    {"parameter": "combine.k_depth", "matters": true, "equally_good": [0.008, 0.02]},
    {"parameter": "dihedral.normals", "matters": false}
  ],
  "stopped": STOPPED,
  "cost": {"candidates": 42}
})";

const std::string kProfiles = R"(parameter,from,value,objective,error
combine.k_depth,default,0.001,0.1,
combine.k_depth,tuned,0.001,0.2,
combine.k_depth,tuned,0.02,0.895,
combine.k_depth,tuned,0.1,0.845,
dihedral.normals,tuned,surface,0.9,
dihedral.normals,tuned,both,0.9,
)";

const std::string kLine =
    R"({"done":7,"total":50,"objective":0.4,"best":0.8,"values":{"combine.k_depth":"0.02"},"seconds":0.2})";

class FitRunTest : public testing::Test {
 protected:
  /// The program does what `script` says; "$4" is the folder.
  FitRun run(const std::string& script) {
    const auto program = folder_.write("program", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return FitRun(program, "/fit.toml", out());
  }
  void write_result(bool stopped) {
    std::string tuning = kTuning;
    tuning.replace(tuning.find("STOPPED"), 7, stopped ? "true" : "false");
    std::filesystem::create_directories(out());
    write_file_atomically(out() / "tuning.json", tuning);
    write_file_atomically(out() / "profiles.csv", kProfiles);
  }
  static void poll_until(FitRun& run, const std::function<bool()>& holds) {
    for (int i = 0; i < 2000 && !holds(); ++i) {
      run.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_TRUE(holds());
  }
  static void finish(FitRun& run) {
    poll_until(run, [&] { return run.is_over(); });
  }
  std::filesystem::path out() const { return folder_.path() / "found"; }

  TemporaryFolder folder_;
};

TEST_F(FitRunTest, runs_the_command_that_a_person_would) {
  FitRun fit = run(R"(echo "error: $@"; echo "inkbench: error: $*" >&2; exit 1)");
  finish(fit);
  EXPECT_EQ(fit.state(), FitState::failed);
  EXPECT_EQ(fit.problem(), "tune /fit.toml --out " + out().string() + " --no-report --progress json");
}

TEST_F(FitRunTest, tells_how_far_it_is_and_the_best_so_far) {
  FitRun fit = run("echo 'Fit: 1 picture'; echo '{\"done\":1,\"total\":50,\"best\":0.5}'; echo '" + kLine +
                   "'; sleep 60");
  poll_until(fit, [&] { return fit.progress().done == 7; });
  EXPECT_EQ(fit.progress().total, 50U);
  EXPECT_THAT(fit.trace(), ElementsAre(FitRun::TracePoint{1, 0.5}, FitRun::TracePoint{7, 0.8}));
  EXPECT_THAT(fit.progress().values, ElementsAre(std::pair("combine.k_depth", "0.02")));
}

TEST_F(FitRunTest, damaged_progress_is_passed_over) {
  for (const char* line : {"", "Fit", "{", "[]", "{}", R"({"done":-1})", R"({"done":"x","best":1})"})
    EXPECT_FALSE(parse_fit_progress(line)) << line;
  const auto odd = parse_fit_progress(R"({"done":3,"best":null,"values":{"a":1}})");
  ASSERT_TRUE(odd);
  EXPECT_FALSE(odd->best);
  EXPECT_TRUE(odd->values.empty());
}

TEST_F(FitRunTest, its_result_says_what_matters_and_how_good_other_values_are) {
  write_result(false);
  FitRun fit = run("exit 0");
  finish(fit);
  ASSERT_EQ(fit.state(), FitState::finished);
  const FitResult& found = fit.result().value();
  EXPECT_EQ(found.before, 0.5);
  EXPECT_EQ(found.after, 0.9);
  EXPECT_EQ(found.left_out, 0.7);
  EXPECT_FALSE(found.is_gain);
  EXPECT_EQ(found.candidates, 42U);
  EXPECT_EQ(indifferent_text(found), "normals does not matter here");
  ASSERT_EQ(found.parameters.size(), 2U);
  EXPECT_FALSE(found.parameters[1].heat) << "a choice has no slider";
  const ValueHeat& heat = found.parameters[0].heat.value();
  EXPECT_EQ(heat.equally_good, std::pair(0.008, 0.02));
  ASSERT_EQ(heat.points.size(), 4U);
  EXPECT_EQ(heat.points[0], (ValueHeat::Point{0.001, 0}));
  EXPECT_EQ(heat.points[1], (ValueHeat::Point{0.01, 1})) << "the found value itself";
  EXPECT_EQ(heat.points[2], (ValueHeat::Point{0.02, 1})) << "within 0.01";
  EXPECT_NEAR(heat.points[3].warmth, 0.5, 1e-9);
}

TEST_F(FitRunTest, found_values_are_taken_into_settings_that_have_them) {
  write_result(false);
  Settings settings = paper_settings();
  const Settings next = with_fit(settings, read_fit_result(out()));
  EXPECT_EQ(next.combine.k_depth, 0.01F);
  EXPECT_EQ(next.dihedral.normals, BendNormals::both);
  EXPECT_EQ(next.combine.k_normal, settings.combine.k_normal);
  FitResult gone;
  gone.parameters = {{"model.gone.size", "1", true, {}}};
  EXPECT_THAT(error_of([&] { with_fit(settings, gone); }), HasSubstr("model.gone.size"));
}

TEST_F(FitRunTest, cancelled_it_keeps_the_best_so_far_and_blames_no_parameter) {
  write_result(true);
  FitRun fit = run("trap 'echo \"inkbench: error: stopped\" >&2; exit 1' INT; echo '" + kLine +
                   "'; while true; do sleep 0.05; done");
  poll_until(fit, [&] { return fit.progress().done == 7; });
  fit.cancel();
  EXPECT_EQ(fit.state(), FitState::stopping);
  finish(fit);
  EXPECT_EQ(fit.state(), FitState::stopped);
  EXPECT_EQ(fit.problem(), "");
  EXPECT_EQ(fit.result().value().after, 0.9);
  EXPECT_EQ(indifferent_text(*fit.result()), "");
}

TEST_F(FitRunTest, ended_by_force_it_keeps_what_it_told) {
  FitRun fit = run("trap '' INT; echo '" + kLine + "'; while true; do sleep 0.05; done");
  poll_until(fit, [&] { return fit.progress().done == 7; });
  fit.cancel();
  fit.cancel();
  finish(fit);
  EXPECT_EQ(fit.state(), FitState::stopped);
  const FitResult& found = fit.result().value();
  EXPECT_TRUE(found.stopped);
  EXPECT_EQ(found.after, 0.8);
  EXPECT_EQ(with_fit(paper_settings(), found).combine.k_depth, 0.02F);
}

TEST_F(FitRunTest, a_damaged_result_and_a_crash_are_told) {
  std::filesystem::create_directories(out());
  write_file_atomically(out() / "profiles.csv", kProfiles);
  write_file_atomically(out() / "tuning.json", "{\"default\": 3}");
  FitRun damaged = run("exit 0");
  finish(damaged);
  EXPECT_EQ(damaged.state(), FitState::failed);
  EXPECT_THAT(damaged.problem(), HasSubstr("tuning.json"));
  FitRun crash = run("kill -SEGV $$");
  finish(crash);
  EXPECT_EQ(crash.state(), FitState::failed);
  EXPECT_THAT(crash.problem(), HasSubstr("Segmentation fault"));
}

}  // namespace
}  // namespace inkbench
