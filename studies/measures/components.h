// SPDX-License-Identifier: MIT
// Connected parts and free ends of lines. In: a line map, as a rule thinned. Out: counts, or the parts
// themselves.
#pragma once

#include "pipeline/lines/line_map.h"

namespace inkbench {

/// The number of 8-connected components of the true pixels.
int64_t component_count(const LineMap& map);

/// Each component's pixels row by row, in order of the components' first pixels.
std::vector<std::vector<Pixel>> components_of(const LineMap& map);

/// The number of true pixels with exactly one true pixel among their eight neighbours. A pixel that stands
/// alone has no neighbour and is no end.
int64_t end_count(const LineMap& map);

}  // namespace inkbench
