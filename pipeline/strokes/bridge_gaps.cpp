// SPDX-License-Identifier: MIT
#include "pipeline/strokes/bridge_gaps.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/strokes/path_links.h"

namespace inkbench {
namespace {

constexpr float kLeastCosine = 0.7071F;
/// Ends that are nearer than this meet: the way between them has no direction.
constexpr float kMeetPx = 0.5F;

/// Below 0 where there is no bridge.
float bridge_cost(const PathEnd& a, const PathEnd& b, float longest_px) {
  const glm::vec2 way = b.at - a.at;
  const float length = glm::length(way);
  if (length > longest_px) return -1.0F;
  const float agree = -glm::dot(a.outwards, b.outwards);
  if (agree < kLeastCosine) return -1.0F;
  if (length > kMeetPx) {
    const glm::vec2 direction = way / length;
    if (glm::dot(a.outwards, direction) < kLeastCosine) return -1.0F;
    if (-glm::dot(b.outwards, direction) < kLeastCosine) return -1.0F;
  }
  return length + longest_px * (1.0F - agree);
}

/// From the end of the path to `to`, which may be one of its own, arriving in the direction `arriving`: a
/// cubic, a point every pixel.
void draw_over_gap(StrokePath& path, PathPoint to, const glm::vec2& arriving) {
  const PathPoint from = path.points.back();
  const float length = glm::distance(from.at, to.at);
  const glm::vec2 leaving = end_of(path, 1).outwards;
  const int steps = std::max(static_cast<int>(std::ceil(length)), 1);
  float along = from.along_px;
  for (int i = 1; i <= steps; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(steps), u = 1.0F - t;
    const glm::vec2 at = u * u * (1.0F + 2.0F * t) * from.at + t * t * (3.0F - 2.0F * t) * to.at +
                         length * (t * u * u * leaving - t * t * u * arriving);
    const bool is_known = from.depth > 0.0F && to.depth > 0.0F;
    const float depth = is_known ? glm::mix(from.depth, to.depth, t) : std::max(from.depth, to.depth);
    along += glm::distance(path.points.back().at, at);
    path.points.push_back({at, along, depth, from.curve_class});
  }
}

void put_behind_gap(StrokePath& path, const StrokePath& next) {
  unite(path, next);
  draw_over_gap(path, next.points.front(), -end_of(next, 0).outwards);
  const float shift = path.points.back().along_px - next.points.front().along_px;
  path.points.back().curve_class = next.points.front().curve_class;
  for (size_t i = 1; i < next.points.size(); ++i) {
    path.points.push_back(next.points[i]);
    path.points.back().along_px += shift;
  }
  for (PlaceAlong place : next.places) {
    place.along_px += shift;
    path.places.push_back(place);
  }
}

}  // namespace

std::vector<StrokePath> bridge_gaps(const std::vector<StrokePath>& paths, float longest_px) {
  if (!(longest_px > 0.0F)) return paths;
  const auto cost_of = [&](const PathEnd& a, const PathEnd& b) {
    // A path that is hardly longer than the gap is no loop.
    if (a.path() == b.path() && length_px(paths[a.path()]) < 3.0F * longest_px) return -1.0F;
    const float cost = bridge_cost(a, b, longest_px);
    if (cost < 0.0F) return cost;
    // What is hardly longer than the gap says little about where the line goes.
    const float shorter = std::min(length_px(paths[a.path()]), length_px(paths[b.path()]));
    return cost + longest_px * std::max(1.0F - 0.5F * shorter / longest_px, 0.0F);
  };
  return linked(paths, links_between(paths, longest_px, cost_of), put_behind_gap, [](StrokePath& path) {
    draw_over_gap(path, path.points.front(), -end_of(path, 0).outwards);
    close_path(path);
  });
}

}  // namespace inkbench
