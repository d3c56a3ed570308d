// SPDX-License-Identifier: MIT
// `inkbench tune` as a program: what it writes, that its scores are a study's, that it can be cut off.
#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;

class Tune : public StudyTest {
 protected:
  Tune() {
    write("s.toml",
          "title = \"Small\"\nscene = \"scene.toml\"\nsize = [96, 72]\nbudget = 60\n"
          "[[search]]\nkey = \"combine.k_depth\"\n[[search]]\nkey = \"combine.k_normal\"\n"
          "[[view]]\nname = \"front\"\n[[view]]\nname = \"side\"\n[view.set]\ncamera.eye = [9, 3, 3]\n");
  }

  CommandResult tune(const std::string& out, const CommandOptions& options = {}) const {
    return inkbench({"tune", "s.toml", "--out", out}, options);
  }

  nlohmann::json result(const std::string& out) const {
    return nlohmann::json::parse(content_of(file(out) / "tuning.json"));
  }

  std::string objective(const nlohmann::json& score) const { return score.at("objective").dump(); }

  /// Interrupted or killed once so many lines are in the journal.
  CommandOptions signal_after_trials(const std::string& out, long lines, int signal) const {
    CommandOptions options;
    options.signal_when = [journal = file(out) / "trials.txt", lines, signal](double) {
      std::error_code error;
      if (!fs::exists(journal, error)) return 0;
      const std::string text = content_of(journal);
      return std::count(text.begin(), text.end(), '\n') >= lines ? signal : 0;
    };
    return options;
  }
};

TEST_F(Tune, scores_are_those_of_a_study_with_the_same_values) {
  ASSERT_TRUE(succeeds(tune("out")));
  const nlohmann::json found = result("out");
  const StudyTable cells = table("out");
  EXPECT_EQ(cells.column("variant"), (std::vector<std::string>{"paper", "default", "tuned"}));
  EXPECT_EQ(cells.column("f1"),
            (std::vector<std::string>{objective(found.at("paper")), objective(found.at("default")),
                                      objective(found.at("tuned"))}));
  EXPECT_GE(found.at("tuned").at("objective"), found.at("default").at("objective"));
  // The preset by itself, in a study of its own.
  write("check.toml",
        "scene = \"out/tuned.toml\"\nmeasure = [\"f1\"]\n[[view]]\nname = \"front\"\n[[view]]\nname = "
        "\"side\"\n"
        "[view.set]\ncamera.eye = [9, 3, 3]\n");
  ASSERT_TRUE(succeeds(study("check", "check")));
  EXPECT_EQ(table("check").column("f1"), std::vector<std::string>{objective(found.at("tuned"))});
}

TEST_F(Tune, leaves_a_report_that_begins_with_what_came_out) {
  ASSERT_TRUE(succeeds(tune("out")));
  const std::string page = content_of(file("out") / "index.html");
  EXPECT_THAT(result("out").at("verdict").get<std::string>(), HasSubstr("it was not tuned on, F is"));
  EXPECT_THAT(page, HasSubstr("it was not tuned on, F is"));
  for (const char* part : {"What each parameter is worth", "Leave-one-out", "charts/box.svg", "tuned.toml"})
    EXPECT_THAT(page, HasSubstr(part));
  EXPECT_THAT(content_of(file("out") / "trace.csv"),
              HasSubstr("trial,stage,combine.k_depth,combine.k_normal,error,objective"));
  EXPECT_TRUE(succeeds(inkbench({"study", "verify", "out"})));
}

TEST_F(Tune, killed_it_takes_the_same_way_and_measures_only_what_was_left) {
  ASSERT_TRUE(succeeds(tune("whole")));
  const nlohmann::json whole = result("whole");
  EXPECT_EQ(tune("out", signal_after_trials("out", 40, SIGKILL)).signal, SIGKILL);
  ASSERT_TRUE(succeeds(tune("out")));
  EXPECT_EQ(content_of(file("out") / "trace.csv"), content_of(file("whole") / "trace.csv"));
  EXPECT_LE(result("out").at("cost").at("drawings_measured"),
            whole.at("cost").at("drawings_measured").get<int>() - 40);
}

TEST_F(Tune, interrupted_it_gives_the_best_so_far) {
  const CommandResult stopped = tune("out", signal_after_trials("out", 40, SIGINT));
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.err, HasSubstr("the same command continues"));
  const nlohmann::json found = result("out");
  EXPECT_TRUE(found.at("stopped").get<bool>());
  EXPECT_GE(found.at("tuned").at("objective"), found.at("default").at("objective"));
  EXPECT_TRUE(succeeds(inkbench({"render", "--scene", "out/tuned.toml", "--out", "r"})));
}

TEST_F(Tune, candidates_that_cannot_be_drawn_are_told_and_never_the_best) {
  write("bad.toml",
        "scene = \"scene.toml\"\nsize = [96, 72]\nbudget = 12\n[set]\ncamera.far = 20\n"
        "[[search]]\nkey = \"camera.near\"\nfrom = 25\nto = 30\n");
  const CommandResult result = inkbench({"tune", "bad.toml", "--out", "out"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("camera.near: = "));
  EXPECT_THAT(content_of(file("out") / "trace.csv"), HasSubstr("could not be drawn"));
  EXPECT_EQ(this->result("out").at("tuned").at("values"), this->result("out").at("default").at("values"));
}

TEST_F(Tune, dry_run_says_what_would_be_searched) {
  const CommandResult plan = inkbench({"tune", "s.toml", "--dry-run", "--budget", "20", "--out", "out"});
  ASSERT_TRUE(succeeds(plan));
  EXPECT_THAT(plan.out, HasSubstr("2 pictures of 2 views, at most 20 candidates, 96 x 72 px"));
  EXPECT_THAT(plan.out, HasSubstr("combine.k_normal: 0.001 to 0.5, log"));
  EXPECT_FALSE(fs::exists(file("out")));
}

}  // namespace
}  // namespace inkbench
