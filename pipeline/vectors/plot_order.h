// SPDX-License-Identifier: MIT
// In which order and direction a pen draws lines, so that it travels little between them. In: lines. Out:
// the same lines in order, and how far the pen travels lifted.
#pragma once

#include "pipeline/vectors/plot_lines.h"

namespace inkbench {

/// How far a pen travels lifted that begins at (0, 0) and draws the lines one after another.
double lifted_travel(const std::vector<PlotLine>& lines);

/// Always to the nearest end of a line that is left (closed ones begin at any of their points); then parts of
/// the way are turned round for as long as that shortens it (2-opt). Never farther than in the order given.
std::vector<PlotLine> in_short_order(std::vector<PlotLine> lines);

}  // namespace inkbench
