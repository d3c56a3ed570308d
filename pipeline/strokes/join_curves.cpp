// SPDX-License-Identifier: MIT
#include "pipeline/strokes/join_curves.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/strokes/coherent_noise.h"

namespace inkbench {
namespace {

using CurveRun = std::vector<const Curve*>;

bool goes_on(const Curve& curve, const Curve& next) {
  return curve.chain == next.chain && curve.end == CurveEnd::other_class && curve.covered == next.covered &&
         curve.object_id == next.object_id && curve.points.back() == next.points.front();
}

bool is_outline(const CurveRun& run) {
  double outline = 0.0, all = 0.0;
  for (const Curve* curve : run) {
    const double length = length_px(*curve);
    all += length;
    if (curve->behind == Behind::other_object || curve->behind == Behind::nothing) outline += length;
  }
  return 2.0 * outline > all;
}

uint32_t rounded(float px) {
  return static_cast<uint32_t>(static_cast<int32_t>(std::lround(px / 8.0F)));
}

/// Of what the path lies on, so that the same stroke of another frame has the same; where nothing is known,
/// of where it lies.
uint32_t number_of(const StrokePath& path) {
  uint64_t lowest = 0;
  for (const PlaceAlong& place : path.places) {
    if (lowest == 0 || place.place < lowest) lowest = place.place;
  }
  uint32_t number = hashed(static_cast<uint32_t>(path.object_id), path.covered > 0 ? 1U : 0U);
  if (lowest != 0) {
    number = hashed(number, static_cast<uint32_t>(lowest));
    return hashed(number, static_cast<uint32_t>(lowest >> 32));
  }
  number = hashed(number, static_cast<uint32_t>(path.points.front().curve_class));
  for (const PathPoint& point : {path.points.front(), path.points.back()})
    number = hashed(hashed(number, rounded(point.at.x)), rounded(point.at.y));
  return number;
}

/// Both have the point where one goes over into the other.
void append(StrokePath& path, const Curve& curve) {
  double along = path.points.empty() ? 0.0 : path.points.back().along_px;
  if (!path.points.empty()) path.points.pop_back();
  for (size_t i = 0; i < curve.points.size(); ++i) {
    if (i > 0) along += glm::distance(glm::dvec2(curve.points[i - 1]), glm::dvec2(curve.points[i]));
    const auto along_px = static_cast<float>(along);
    const float depth = i < curve.depths.size() ? curve.depths[i] : 0.0F;
    path.points.push_back({curve.points[i], along_px, depth, curve.curve_class});
    const uint64_t place = i < curve.places.size() ? curve.places[i] : 0;
    const bool is_there = !path.places.empty() && path.places.back().place == place;
    if (place != 0 && !is_there) path.places.push_back({place, along_px});
  }
}

StrokePath path_of(const CurveRun& run) {
  StrokePath path;
  path.object_id = run.front()->object_id;
  path.covered = run.front()->covered;
  path.is_traced = run.front()->is_traced;
  path.is_outline = is_outline(run);
  path.start = run.front()->start;
  path.end = run.back()->end;
  for (const Curve* curve : run) append(path, *curve);
  const bool meets = path.points.size() > 2 && path.points.front().at == path.points.back().at;
  const auto goes_round = [](CurveEnd end) {
    return end == CurveEnd::closed || end == CurveEnd::other_class;
  };
  path.is_closed = meets && goes_round(path.start) && goes_round(path.end);
  const bool ends_where_it_began =
      path.places.size() > 1 && path.places.front().place == path.places.back().place;
  if (path.is_closed && ends_where_it_began) path.places.pop_back();
  path.number = number_of(path);
  return path;
}

}  // namespace

std::vector<StrokePath> join_curves(const Curves& curves, const StrokeClasses& classes, bool with_hidden) {
  std::vector<StrokePath> paths;
  CurveRun run;
  const auto finish = [&] {
    if (!run.empty()) paths.push_back(path_of(run));
    run.clear();
  };
  for (const Curve& curve : curves.curves) {
    const bool is_drawn = curve.points.size() >= 2 && (curve.covered == 0 || with_hidden) &&
                          classes[static_cast<size_t>(curve.curve_class)].width > 0.0F;
    if (!run.empty() && !(is_drawn && goes_on(*run.back(), curve))) finish();
    if (is_drawn) run.push_back(&curve);
  }
  finish();
  return paths;
}

}  // namespace inkbench
