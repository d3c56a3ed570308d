// SPDX-License-Identifier: MIT
// `inkbench measure`: a drawing against its own reference lines, without a study.
#include <nlohmann/json.hpp>

#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

class MeasureCommand : public StudyTest {
 protected:
  nlohmann::json measured(std::vector<std::string> options) const {
    options.insert(options.begin(), {"measure", "--scene", "scene.toml", "--json"});
    const CommandResult result = inkbench(options);
    EXPECT_TRUE(succeeds(result));
    return nlohmann::json::parse(result.out);
  }
};

TEST_F(MeasureCommand, equals_a_study_to_the_last_digit) {
  const std::vector<std::string> judged{"--set", "judge.tolerance=1", "--set", "judge.crease=allowed"};
  write_spec("s",
             "size = [160, 120]\nmeasure = true\n[set]\njudge.tolerance = 1\njudge.crease = \"allowed\"\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  const std::map<std::string, std::string> row = table("out").rows.at(0);
  std::vector<std::string> options{"--size", "160x120"};
  options.insert(options.end(), judged.begin(), judged.end());
  const nlohmann::json numbers = measured(options);
  EXPECT_GT(numbers.size(), 30U);
  for (const auto& [key, value] : numbers.items()) {
    ASSERT_TRUE(row.contains(key)) << key;
    if (value.is_number()) {
      EXPECT_EQ(value.get<double>(), std::stod(row.at(key))) << key;
    } else {
      EXPECT_EQ(value.is_null() ? "" : value.dump(), row.at(key)) << key;
    }
  }
}

TEST_F(MeasureCommand, a_wider_tolerance_matches_more) {
  const nlohmann::json strict = measured({"--set", "judge.tolerance=0"});
  const nlohmann::json wide = measured({"--set", "judge.tolerance=20"});
  EXPECT_LT(strict.at("matched"), wide.at("matched"));
  EXPECT_EQ(strict.at("predicted"), wide.at("predicted"));
}

TEST_F(MeasureCommand, an_exported_image_is_measured_from_what_it_carries) {
  ASSERT_TRUE(succeeds(
      inkbench({"render", "--scene", "scene.toml", "--set", "combine.k_normal=0.05", "--out", "rendered"})));
  const CommandResult again = inkbench({"measure", "--from", "rendered/final.png", "--json"});
  ASSERT_TRUE(succeeds(again));
  EXPECT_EQ(nlohmann::json::parse(again.out), measured({"--set", "combine.k_normal=0.05"}));
}

TEST_F(MeasureCommand, table_says_what_each_number_means) {
  const CommandResult result = inkbench({"measure", "--scene", "scene.toml"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, HasSubstr("tolerance 2 px"));
  EXPECT_THAT(result.out, HasSubstr("Of what is drawn, this share belongs."));
}

TEST_F(MeasureCommand, a_judge_out_of_range_is_refused) {
  EXPECT_TRUE(
      is_input_error(inkbench({"measure", "--set", "judge.tolerance=-1"}), {"judge.tolerance", "0 to 100"}));
  EXPECT_TRUE(is_input_error(inkbench({"measure", "--set", "judge.silhouette=must"}), {"must", "wanted"}));
}

}  // namespace
}  // namespace inkbench
