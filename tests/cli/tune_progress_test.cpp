// SPDX-License-Identifier: MIT
// A search for another program: what it is told meanwhile, and data without a report.
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/cli_test.h"

namespace inkbench {
namespace {

class TuneProgress : public CliTest {};

TEST_F(TuneProgress, tells_the_best_values_and_leaves_data_alone) {
  write("scene.toml", small_scene());
  write("t.toml",
        "scene = \"scene.toml\"\nbudget = 30\n[[search]]\nkey = \"combine.k_depth\"\n"
        "[[search]]\nkey = \"combine.k_normal\"\n");
  const CommandResult result =
      inkbench({"tune", "t.toml", "--out", "out", "--no-report", "--progress", "json"});
  ASSERT_TRUE(succeeds(result));
  nlohmann::json last;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('{')) last = nlohmann::json::parse(line);
  }
  const auto tuned = nlohmann::json::parse(content_of(file("out/tuning.json")))["tuned"];
  EXPECT_EQ(last["values"], tuned["values"]);
  EXPECT_EQ(last["best"], tuned["objective"]);
  EXPECT_TRUE(fs::exists(file("out/profiles.csv")));
  EXPECT_FALSE(fs::exists(file("out/index.html")));
}

}  // namespace
}  // namespace inkbench
