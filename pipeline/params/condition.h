// SPDX-License-Identifier: MIT
// What must be set for a parameter to have an effect, read from its `matters_when`. In: "use_depth = true",
// "edges.method != paper and line.width_unit = px or percent". Out: the keys and the values that are named.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

struct Condition {
  std::string key;                  ///< With a dot any parameter's; else that of one of the same group.
  std::vector<std::string> values;  ///< Any of them.
  bool is_unequal = false;          ///< None of them.
};

/// Those joined by " and "; none for an empty text. Errors (input): a part without " = " or " != ".
std::vector<Condition> parse_conditions(std::string_view text);

}  // namespace inkbench
