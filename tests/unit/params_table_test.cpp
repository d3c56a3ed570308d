// SPDX-License-Identifier: MIT
// The table of all parameters.
#include "pipeline/settings/params_table.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "pipeline/settings/settings.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> all_keys() {
  Settings settings;
  settings.models.emplace_back().name = "<name>";
  settings.lights.emplace_back().name = "<name>";
  std::vector<std::string> keys;
  for (const Param& param : list_params(settings)) keys.push_back(param.key);
  return keys;
}

TEST(ParamsTable, text_shows_each_key_with_default_unit_and_limits) {
  const std::string table = params_table(TableFormat::text);
  for (const std::string& key : all_keys()) EXPECT_THAT(table, HasSubstr("\n  " + key + " = "));
  EXPECT_THAT(
      table,
      HasSubstr(
          "  combine.k_depth = 0.003 (1e-06 to 1)\n"
          "      Sensitivity of the depth term: smaller draws more lines. Matters when use_depth = true.\n"));
  EXPECT_THAT(table, HasSubstr("  camera.fov = 45 deg (0.01 to 170)\n"));
}

TEST(ParamsTable, markdown_has_a_row_of_six_cells_for_each_key) {
  const std::string table = params_table(TableFormat::markdown);
  for (const std::string& key : all_keys()) EXPECT_THAT(table, HasSubstr("\n| `" + key + "` | "));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("|")) continue;
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 7) << line;
  }
}

TEST(ParamsTable, json_has_an_entry_for_each_key) {
  const std::string table = params_table(TableFormat::json);
  for (const std::string& key : all_keys()) EXPECT_THAT(table, HasSubstr("\"key\": \"" + key + "\""));
  EXPECT_EQ(table.front(), '[');
  EXPECT_THAT(table, HasSubstr("\"scale\": \"log\""));
}

}  // namespace
}  // namespace inkbench
