// SPDX-License-Identifier: MIT
// The lines that should be in a picture, by tier: one drawing of them.
#pragma once

#include <optional>

#include "pipeline/lines/line_map.h"

namespace inkbench {

struct TieredLines {
  LineMap wanted;                  ///< Tier 1: a drawing must have them.
  std::optional<LineMap> allowed;  ///< Tier 2: it may have them.
};

}  // namespace inkbench
