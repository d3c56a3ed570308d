// SPDX-License-Identifier: MIT
// Centre lines for pen plotters as an SVG file in millimetres. In: curves or strokes. Out: the file's text.
#pragma once

#include <string>

#include "pipeline/curves/curve.h"
#include "pipeline/strokes/stroke.h"
#include "pipeline/vectors/plot_lines.h"
#include "pipeline/vectors/svg_page.h"

namespace inkbench {

/// What is drawn by pen, in px; what is covered apart.
struct PlotDrawing {
  std::vector<PlotLine> lines, hidden;
};

PlotDrawing plot_drawing(const Curves& curves);
/// The middles of the strokes, wobble, passes and dashes included; widths are the pen's.
PlotDrawing plot_drawing(const Strokes& strokes);

struct PlotOptions {
  double width_mm = 200.0;  ///< Of the sheet; its height follows the image's shape.
  bool draws_hidden = false;
};

/// How far a pen travels lifted, in mm.
struct PlotTravel {
  double before = 0.0, after = 0.0;
};

struct Plot {
  std::string svg;
  size_t lines = 0;   ///< How often the pen comes down.
  PlotTravel travel;  ///< In the drawing's order and in that of the file.
};

/// Cut at the image's edges, joined where ends coincide and in an order of little travel: a path for each
/// line in the group `plot`, then those of the group `hidden`, where asked for. Fitted within 0.11 px. The
/// file tells the travel.
Plot plot_svg(const PlotDrawing& drawing, const PlotOptions& options, const VectorPage& page);

}  // namespace inkbench
