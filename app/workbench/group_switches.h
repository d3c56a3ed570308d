// SPDX-License-Identifier: MIT
// Sets of values that a group of parameters can be switched between with one click: beside the method of
// finding lines the paper's numbers and the suggested ones. In: settings. Out: settings.
#pragma once

#include <span>
#include <string_view>

#include "pipeline/settings/settings.h"

namespace inkbench {

struct GroupSwitch {
  std::string_view group;  ///< The prefix of the group that it stands in.
  std::string_view label, help;
  std::string_view step;  ///< Its name in the history.
  bool (*is_on)(const Settings& settings) = nullptr;
  void (*apply)(Settings& settings) = nullptr;
};

/// All of them; those of one group stand side by side.
std::span<const GroupSwitch> group_switches();

}  // namespace inkbench
