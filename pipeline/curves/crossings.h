// SPDX-License-Identifier: MIT
// Where lines pass behind others in the image. In: the lines of a view. Out: the same with a point wherever
// a line that covers and is nearer, or as near, crosses or touches; on lines that cover also where a farther
// one passes, since from there on something else lies behind them. Source: Appel, "The notion of quantitative
// invisibility", 1967: between such points, cusps and places where surfaces are pierced nothing changes.
#pragma once

#include <vector>

#include "pipeline/curves/view_lines.h"

namespace inkbench {

/// Time in proportion to the lines' length in pixels and the number of crossings.
void split_at_crossings(std::vector<ViewLine>& lines, int width_px, int height_px);

}  // namespace inkbench
