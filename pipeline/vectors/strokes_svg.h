// SPDX-License-Identifier: MIT
// Strokes as an SVG file of filled outlines. In: strokes and their style. Out: the file's text.
#pragma once

#include <string>

#include "pipeline/settings/ink_params.h"
#include "pipeline/settings/stroke_params.h"
#include "pipeline/strokes/stroke.h"
#include "pipeline/vectors/surface_colours.h"
#include "pipeline/vectors/svg_page.h"

namespace inkbench {

/// What strokes are coloured by.
struct StrokeInk {
  StrokeParams stroke;
  StrokeClasses classes = default_stroke_classes();
  InkParams ink;
  SurfaceColours surface;  ///< Of `stroke.colour` = material or shading alone.
};

/// How far an outline of the file is from the discs along the stroke at most.
inline constexpr double kOutlineErrorPx = 0.07;

/// A group for each class and object (`class_groups`): in it the union of its strokes of one colour, a path
/// for each part of it that hangs together. As OpenGL draws them: where classes overlap the earlier one is on
/// top, and together they hide as much as the one that hides most. Covered strokes are dashes already and lie
/// in the group `hidden`, drawn only with `stroke.hidden`. Colours of the shading are taken step by step,
/// rounded to 1/15. A brush's paint cannot be held by outlines: the file says so. `below`: elements under the
/// strokes.
std::string strokes_svg(const Strokes& strokes, const StrokeInk& ink, const VectorPage& page,
                        const std::string& below = "");

}  // namespace inkbench
