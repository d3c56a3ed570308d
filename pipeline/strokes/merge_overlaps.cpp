// SPDX-License-Identifier: MIT
#include "pipeline/strokes/merge_overlaps.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "pipeline/strokes/path_links.h"

namespace inkbench {
namespace {

constexpr float kNearPx = 2.0F;
constexpr float kMostOverlapPx = 20.0F;
constexpr float kLeastAgreement = 0.7071F;
/// What a link adds to each of both paths at least.
constexpr float kLeastGainPx = 0.5F;
constexpr int kRounds = 2;
constexpr float kShortPx = 12.0F;
constexpr float kCellPx = 2.0F;

bool is_outline_class(CurveClass curve_class) {
  return curve_class == CurveClass::silhouette || curve_class == CurveClass::boundary ||
         curve_class == CurveClass::object;
}

/// How far from the end of the path its point nearest to `at` lies, and how near that is.
struct Foot {
  float from_end_px = 0.0F, away_px = 1e9F;
};
Foot foot_near_end(const StrokePath& path, bool at_start, const glm::vec2& at) {
  const std::vector<PathPoint>& points = path.points;
  Foot best;
  const size_t count = points.size();
  const float end = at_start ? points.front().along_px : points.back().along_px;
  for (size_t k = 1; k < count; ++k) {
    const PathPoint& a = at_start ? points[k - 1] : points[count - k];
    const PathPoint& b = at_start ? points[k] : points[count - 1 - k];
    if (std::abs(a.along_px - end) > kMostOverlapPx) break;
    const glm::vec2 way = b.at - a.at;
    const float square = glm::dot(way, way);
    const float share = square > 0.0F ? glm::clamp(glm::dot(at - a.at, way) / square, 0.0F, 1.0F) : 0.0F;
    const float away = glm::distance(at, a.at + share * way);
    if (away < best.away_px) best = {std::abs(glm::mix(a.along_px, b.along_px, share) - end), away};
  }
  return best;
}

/// What both have in common, from each one's end: below 0 where they do not overlap.
struct Overlap {
  float of_a_px = -1.0F, of_b_px = -1.0F, away_px = 0.0F;
};
Overlap overlap_of(const StrokePath& a, bool a_at_start, const StrokePath& b, bool b_at_start) {
  const glm::vec2 a_end = a_at_start ? a.points.front().at : a.points.back().at;
  const glm::vec2 b_end = b_at_start ? b.points.front().at : b.points.back().at;
  const Foot on_b = foot_near_end(b, b_at_start, a_end), on_a = foot_near_end(a, a_at_start, b_end);
  if (std::max(on_a.away_px, on_b.away_px) > kNearPx) return {};
  if (length_px(a) < on_a.from_end_px + kLeastGainPx || length_px(b) < on_b.from_end_px + kLeastGainPx)
    return {};
  return {on_a.from_end_px, on_b.from_end_px, std::max(on_a.away_px, on_b.away_px)};
}

/// Direction out of the path where it is so far from its end.
glm::vec2 direction_out(const StrokePath& path, bool at_start, float from_end_px) {
  const float end = at_start ? path.points.front().along_px : path.points.back().along_px;
  const glm::vec2 along = direction_at(path, at_start ? end + from_end_px : end - from_end_px, 6.0F);
  return at_start ? -along : along;
}

float link_cost(const StrokePath& a, const PathEnd& a_end, const StrokePath& b, const PathEnd& b_end) {
  const bool is_loop = a_end.path() == b_end.path();
  if (is_loop && length_px(a) < 3.0F * kMostOverlapPx) return -1.0F;
  const Overlap overlap = overlap_of(a, a_end.is_start(), b, b_end.is_start());
  if (overlap.of_a_px < 0.0F) return -1.0F;
  const float agree = -glm::dot(direction_out(a, a_end.is_start(), 0.5F * overlap.of_a_px),
                                direction_out(b, b_end.is_start(), 0.5F * overlap.of_b_px));
  if (agree < kLeastAgreement) return -1.0F;
  // Of several that go on, the one that leads farther.
  const float gain = std::min(length_px(b) - overlap.of_b_px, length_px(a) - overlap.of_a_px);
  return overlap.away_px + 2.0F * (1.0F - agree) +
         2.0F * kNearPx * std::max(1.0F - gain / kMostOverlapPx, 0.0F);
}

PathPoint mixed(const PathPoint& a, const PathPoint& b, float share) {
  const bool is_known = a.depth > 0.0F && b.depth > 0.0F;
  return {glm::mix(a.at, b.at, share), 0.0F,
          is_known ? glm::mix(a.depth, b.depth, share) : std::max(a.depth, b.depth),
          share < 0.5F ? a.curve_class : b.curve_class};
}

/// The points of both, the second one's from `path`'s end on.
void put_behind_overlap(StrokePath& path, const StrokePath& next) {
  const Overlap found = overlap_of(path, false, next, true);
  const float of_path = std::max(found.of_a_px, 0.0F), of_next = std::max(found.of_b_px, 0.0F);
  unite(path, next);
  const StrokePath before = path;
  const float from = before.points.back().along_px - of_path, to = next.points.front().along_px + of_next;
  std::erase_if(path.points, [&](const PathPoint& point) { return point.along_px >= from; });
  std::erase_if(path.places, [&](const PlaceAlong& place) { return place.along_px > from + 0.5F * of_path; });
  float along = path.points.empty() ? from : path.points.back().along_px;
  const auto add = [&](PathPoint point) {
    if (!path.points.empty()) along += glm::distance(path.points.back().at, point.at);
    point.along_px = along;
    path.points.push_back(point);
  };
  const int steps = std::max(static_cast<int>(std::ceil(std::max(of_path, of_next))), 1);
  for (int i = 0; i <= steps; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(steps);
    add(mixed(point_at(before, from + share * of_path), point_at(next, to - (1.0F - share) * of_next),
              share));
  }
  const float shift = along - to;
  for (const PathPoint& point : next.points) {
    if (point.along_px > to) add(point);
  }
  for (PlaceAlong place : next.places) {
    if (place.along_px <= to - 0.5F * of_next) continue;
    place.along_px += shift;
    path.places.push_back(place);
  }
}

void close_over_overlap(StrokePath& path) {
  const Overlap found = overlap_of(path, false, path, true);
  const float from = path.points.front().along_px + std::max(found.of_b_px, 0.0F);
  // The end goes on to where the start's own part of the overlap ends.
  std::erase_if(path.points, [&](const PathPoint& point) { return point.along_px < from; });
  std::erase_if(path.places, [&](const PlaceAlong& place) { return place.along_px < from; });
  PathPoint last = path.points.front();
  last.along_px = path.points.back().along_px + glm::distance(last.at, path.points.back().at);
  path.points.push_back(last);
  close_path(path);
}

/// Which paths go through which cells of the image.
class PathCells {
 public:
  explicit PathCells(const std::vector<StrokePath>& paths) {
    for (size_t i = 0; i < paths.size(); ++i) {
      if (length_px(paths[i]) <= kShortPx) continue;
      const StrokePath& path = paths[i];
      for (float along = path.points.front().along_px; along < path.points.back().along_px;
           along += kCellPx) {
        std::vector<size_t>& cell = cells_[cell_of(point_at(path, along).at)];
        if (cell.empty() || cell.back() != i) cell.push_back(i);
      }
    }
  }

  /// One of them that comes near the place.
  template <class Wanted>
  bool has_near(const glm::vec2& at, const Wanted& wanted) const {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const auto found = cells_.find(cell_of(at + kCellPx * glm::vec2(x, y)));
        if (found == cells_.end()) continue;
        if (std::any_of(found->second.begin(), found->second.end(), wanted)) return true;
      }
    }
    return false;
  }

 private:
  static uint64_t cell_of(const glm::vec2& at) {
    const auto x = static_cast<int32_t>(std::floor(at.x / kCellPx));
    const auto y = static_cast<int32_t>(std::floor(at.y / kCellPx));
    return (static_cast<uint64_t>(static_cast<uint32_t>(x)) << 32) | static_cast<uint32_t>(y);
  }
  std::unordered_map<uint64_t, std::vector<size_t>> cells_;
};

void leave_out_short(std::vector<StrokePath>& paths) {
  const PathCells cells(paths);
  std::vector<StrokePath> kept;
  for (const StrokePath& path : paths) {
    const bool is_along =
        length_px(path) <= kShortPx && !path.is_closed &&
        std::all_of(path.points.begin(), path.points.end(), [&](const PathPoint& point) {
          return cells.has_near(point.at, [&](size_t other) { return may_be_one(path, paths[other]); });
        });
    if (!is_along) kept.push_back(path);
  }
  paths = std::move(kept);
}

}  // namespace

std::vector<StrokePath> merge_overlaps(const std::vector<StrokePath>& paths) {
  std::vector<StrokePath> outlines, others;
  for (const StrokePath& path : paths) {
    const bool is_outline = !path.is_traced && is_outline_class(path.points.front().curve_class);
    (is_outline ? outlines : others).push_back(path);
  }
  // Again, since what became longer may go on where its parts did not.
  for (int round = 0; round < kRounds; ++round) {
    const auto cost = [&](const PathEnd& a, const PathEnd& b) {
      return link_cost(outlines[a.path()], a, outlines[b.path()], b);
    };
    outlines = linked(outlines, links_between(outlines, kMostOverlapPx, cost), put_behind_overlap,
                      close_over_overlap);
  }
  leave_out_short(outlines);
  outlines.insert(outlines.end(), others.begin(), others.end());
  return outlines;
}

}  // namespace inkbench
