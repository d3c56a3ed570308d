// SPDX-License-Identifier: MIT
#include "pipeline/strokes/make_strokes.h"

#include <algorithm>

#include "pipeline/strokes/bridge_gaps.h"
#include "pipeline/strokes/carry_along.h"
#include "pipeline/strokes/dashes.h"
#include "pipeline/strokes/join_curves.h"
#include "pipeline/strokes/merge_overlaps.h"
#include "pipeline/strokes/sample_path.h"
#include "pipeline/strokes/smooth_path.h"
#include "pipeline/strokes/wobble.h"

namespace inkbench {
namespace {

std::vector<StrokePath> paths_of(const Curves& curves, const StrokeParams& params,
                                 const StrokeClasses& classes) {
  std::vector<StrokePath> paths = merge_overlaps(join_curves(curves, classes, params.hidden));
  paths = bridge_gaps(paths, params.bridge);
  std::erase_if(paths, [&](const StrokePath& path) {
    return length_px(path) <= 0.0F || length_px(path) < params.shortest;
  });
  std::stable_sort(paths.begin(), paths.end(), [](const StrokePath& a, const StrokePath& b) {
    return (a.covered > 0) > (b.covered > 0);
  });
  for (StrokePath& path : paths) path = smoothed(path, params.smoothing);
  return paths;
}

StrokeCourse course_of(const StrokePath& path) {
  return {path.number, path.is_closed, path.points.front().along_px, path.points.back().along_px,
          path.places};
}

/// One pass over a path; without points where it has no width anywhere.
Stroke drawn_once(const StrokePath& path, const StrokeParams& params, const StrokeClasses& classes,
                  const WidthProfile& profile, const StrokeSurroundings& around, int pass) {
  Stroke stroke{.object_id = path.object_id,
                .covered = path.covered,
                .is_outline = path.is_outline,
                .number = path.number,
                .pass = pass,
                .start_px = path.points.front().along_px,
                .end_px = path.points.back().along_px,
                .points = {},
                .is_closed = path.is_closed};
  const std::vector<float> radii = stroke_radii(path, params, classes, profile, around);
  if (*std::max_element(radii.begin(), radii.end()) <= 0.0F) return stroke;
  const std::vector<glm::vec2> moves = strayed(path, params, pass);
  for (size_t i = 0; i < path.points.size(); ++i) {
    const PathPoint& point = path.points[i];
    stroke.points.push_back({point.at + moves[i], radii[i], point.along_px, point.curve_class});
  }
  if (stroke.is_closed) {
    stroke.points.back().at = stroke.points.front().at;
    stroke.points.back().radius_px = stroke.points.front().radius_px;
  }
  return stroke;
}

}  // namespace

Strokes make_strokes(const Curves& curves, const StrokeParams& params, const StrokeClasses& classes,
                     const StrokeSurroundings& around, const Strokes* before) {
  const WidthProfile profile = parse_profile(params.profile, "stroke.profile");
  std::vector<StrokePath> paths = paths_of(curves, params, classes);
  if (before != nullptr && params.coherent) carry_along(paths, *before);
  Strokes strokes{curves.width_px, curves.height_px, {}, {}};
  for (StrokePath& path : paths) {
    strokes.courses.push_back(course_of(path));
    overshoot(path, params.overshoot);
    const StrokePath fine = sampled(path, longest_step_px(params));
    for (int pass = 0; pass < params.passes; ++pass) {
      Stroke stroke = drawn_once(fine, params, classes, profile, around, pass);
      if (stroke.points.empty()) continue;
      std::vector<Stroke> parts = path.covered > 0 ? dashes_of(stroke, params.dash, params.dash_gap)
                                                   : std::vector<Stroke>{std::move(stroke)};
      std::move(parts.begin(), parts.end(), std::back_inserter(strokes.strokes));
    }
  }
  return strokes;
}

}  // namespace inkbench
