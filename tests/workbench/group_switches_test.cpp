// SPDX-License-Identifier: MIT
// "paper | suggested" beside the method: sets of values that one click switches between.
#include "app/workbench/group_switches.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace inkbench {
namespace {

const GroupSwitch& labelled(std::string_view label) {
  const auto all = group_switches();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const GroupSwitch& each) { return each.label == label; });
  if (found == all.end()) throw std::runtime_error("no switch " + std::string(label));
  return *found;
}

TEST(GroupSwitches, suggested_is_dihedral_with_its_defaults_and_paper_the_papers_numbers) {
  Settings settings;
  settings.combine.k_depth = 0.5F;
  settings.dihedral.angle = 75.0F;
  settings.edges.min_length = 12.0F;
  EXPECT_FALSE(labelled("paper").is_on(settings) || labelled("suggested").is_on(settings));
  labelled("suggested").apply(settings);
  EXPECT_EQ(settings.edges.method, EdgeMethod::dihedral);
  EXPECT_EQ(settings.dihedral.angle, DihedralParams{}.angle);
  EXPECT_EQ(settings.edges.min_length, 0.0F);
  EXPECT_EQ(settings.combine.k_depth, 0.5F) << "another method's numbers stay";
  EXPECT_TRUE(labelled("suggested").is_on(settings));
  EXPECT_FALSE(labelled("paper").is_on(settings));
  labelled("paper").apply(settings);
  EXPECT_EQ(settings.edges.method, EdgeMethod::paper);
  EXPECT_EQ(settings.combine.k_depth, 0.003F);
  EXPECT_EQ(settings.combine.k_normal, 0.0125F);
  EXPECT_TRUE(labelled("paper").is_on(settings));
}

TEST(GroupSwitches, stand_in_a_group_that_there_is) {
  const Settings settings;
  const std::vector<ConstParamGroup> groups = list_groups(settings);
  for (const GroupSwitch& each : group_switches()) {
    EXPECT_TRUE(std::any_of(groups.begin(), groups.end(), [&](const ConstParamGroup& group) {
      return group.prefix == each.group;
    })) << each.label;
  }
}

}  // namespace
}  // namespace inkbench
