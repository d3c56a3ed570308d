// SPDX-License-Identifier: MIT
// What the window looks like at its first start.
#include "app/workbench/window_layout.h"

#include "pipeline/base/text.h"
#include "pipeline/buffers.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

TEST(WindowLayout, first_one_leaves_out_buffers_that_there_are) {
  EXPECT_NO_THROW(parse_buffers(split(WindowLayout().hidden_buffers, ' '), "hidden_buffers"));
}

TEST(WindowLayout, first_one_opens_groups_that_there_are_with_those_of_every_method) {
  const Settings settings;
  const std::vector<std::string> open = split(WindowLayout().open_groups, ' ');
  std::vector<std::string> there;
  for (const ConstParamGroup& group : list_groups(settings)) {
    there.push_back(group.prefix);
    if (group.description->matters_when.starts_with("edges.method = ")) {
      EXPECT_THAT(open, ::testing::Contains(group.prefix));
    }
  }
  EXPECT_THAT(there, ::testing::IsSupersetOf(open));
}

}  // namespace
}  // namespace inkbench
