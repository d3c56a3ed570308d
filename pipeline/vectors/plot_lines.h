// SPDX-License-Identifier: MIT
// What a pen draws without being lifted: lines cut at the sheet's edges and joined where they meet. In:
// polylines. Out: longer ones.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace inkbench {

/// 2 points or more; a closed one repeats its first point at the end.
using PlotLine = std::vector<glm::dvec2>;

bool is_closed(const PlotLine& line);

/// What of the lines lies in the rectangle from (0, 0) to `size`.
std::vector<PlotLine> cut_to_sheet(const std::vector<PlotLine>& lines, const glm::dvec2& size);

/// Ends that lie within `nearness` of each other are one: where two meet, one line goes on; where more do,
/// the straightest pair, then the straightest of the rest. Lines that end where they began are closed.
std::vector<PlotLine> join_ends(const std::vector<PlotLine>& lines, double nearness);

}  // namespace inkbench
