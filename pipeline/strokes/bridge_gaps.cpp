// SPDX-License-Identifier: MIT
#include "pipeline/strokes/bridge_gaps.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

namespace inkbench {
namespace {

constexpr float kLeastCosine = 0.7071F;
/// Over this length an end's direction is looked at.
constexpr float kDirectionPx = 6.0F;
/// Ends that are nearer than this meet: the way between them has no direction.
constexpr float kMeetPx = 0.5F;
constexpr size_t kNone = std::numeric_limits<size_t>::max();

/// End 2i is the start of path i, end 2i + 1 its end.
struct PathEnd {
  size_t number = 0;
  glm::vec2 at{0.0F}, outwards{0.0F};
};

struct Bridge {
  float cost = 0.0F;
  size_t a = 0, b = 0;
  bool operator<(const Bridge& other) const {
    return std::tie(cost, a, b) < std::tie(other.cost, other.a, other.b);
  }
};

glm::vec2 unit(const glm::vec2& v) {
  const float length = glm::length(v);
  return length > 0.0F ? v / length : glm::vec2(0.0F);
}

PathEnd end_of(const StrokePath& path, size_t number) {
  const bool is_start = number % 2 == 0;
  const PathPoint& end = is_start ? path.points.front() : path.points.back();
  const float back = std::min(kDirectionPx, length_px(path));
  const glm::vec2 inside = point_at(path, is_start ? end.along_px + back : end.along_px - back).at;
  return {number, end.at, unit(end.at - inside)};
}

std::vector<PathEnd> open_ends(const std::vector<StrokePath>& paths) {
  std::vector<PathEnd> ends;
  for (size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].is_closed) continue;
    if (paths[i].start != CurveEnd::frame) ends.push_back(end_of(paths[i], 2 * i));
    if (paths[i].end != CurveEnd::frame) ends.push_back(end_of(paths[i], 2 * i + 1));
  }
  std::sort(ends.begin(), ends.end(), [](const PathEnd& a, const PathEnd& b) {
    return std::tie(a.at.x, a.number) < std::tie(b.at.x, b.number);
  });
  return ends;
}

bool may_be_one(const StrokePath& a, const StrokePath& b) {
  const bool same_object = a.object_id == b.object_id || (a.is_traced && b.is_traced);
  return same_object && (a.covered > 0) == (b.covered > 0);
}

/// What the bridge costs; below 0 where there is none.
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

std::vector<Bridge> bridges_of(const std::vector<StrokePath>& paths, float longest_px) {
  const std::vector<PathEnd> ends = open_ends(paths);
  std::vector<Bridge> bridges;
  for (size_t i = 0; i < ends.size(); ++i) {
    for (size_t j = i + 1; j < ends.size() && ends[j].at.x - ends[i].at.x <= longest_px; ++j) {
      const PathEnd &a = ends[std::min(i, j)], &b = ends[std::max(i, j)];
      const size_t path_a = a.number / 2, path_b = b.number / 2;
      if (!may_be_one(paths[path_a], paths[path_b])) continue;
      // A path that is hardly longer than the gap is no loop.
      if (path_a == path_b && length_px(paths[path_a]) < 3.0F * longest_px) continue;
      const float cost = bridge_cost(a, b, longest_px);
      if (cost >= 0.0F) bridges.push_back({cost, std::min(a.number, b.number), std::max(a.number, b.number)});
    }
  }
  std::sort(bridges.begin(), bridges.end());
  return bridges;
}

/// For each end the one that it goes on to, or `kNone`.
std::vector<size_t> linked_ends(const std::vector<StrokePath>& paths, float longest_px) {
  std::vector<size_t> links(2 * paths.size(), kNone);
  for (const Bridge& bridge : bridges_of(paths, longest_px)) {
    if (links[bridge.a] != kNone || links[bridge.b] != kNone) continue;
    links[bridge.a] = bridge.b;
    links[bridge.b] = bridge.a;
  }
  return links;
}

/// From the end of the path to `to`, arriving in the direction `arriving`: a cubic, a point every pixel.
void draw_over_gap(StrokePath& path, const PathPoint& to, const glm::vec2& arriving) {
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

/// Puts `next` behind `path`, over the gap.
void go_on(StrokePath& path, const StrokePath& next) {
  const float length = length_px(path), added = length_px(next);
  const bool outline = path.is_outline == next.is_outline ? path.is_outline
                       : length > added                   ? path.is_outline
                                                          : next.is_outline;
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
  path.end = next.end;
  path.is_outline = outline;
  path.covered = std::min(path.covered, next.covered);
  path.number = std::min(path.number, next.number);
}

/// The chain of paths that goes on from `entry`, an end of the first one.
StrokePath follow(const std::vector<StrokePath>& paths, const std::vector<size_t>& links, size_t entry,
                  std::vector<bool>& is_done) {
  StrokePath chain;
  for (size_t at = entry;;) {
    const StrokePath& path = paths[at / 2];
    is_done[at / 2] = true;
    const StrokePath next = at % 2 == 0 ? path : reversed(path);
    if (chain.points.empty())
      chain = next;
    else
      go_on(chain, next);
    at = links[at ^ 1U];
    if (at == kNone) return chain;
    if (at == entry) {  // round
      draw_over_gap(chain, chain.points.front(), -end_of(chain, 0).outwards);
      chain.points.back().at = chain.points.front().at;
      chain.is_closed = true;
      chain.start = chain.end = CurveEnd::closed;
      return chain;
    }
  }
}

}  // namespace

std::vector<StrokePath> bridge_gaps(std::vector<StrokePath> paths, float longest_px) {
  if (!(longest_px > 0.0F)) return paths;
  const std::vector<size_t> links = linked_ends(paths, longest_px);
  std::vector<StrokePath> bridged;
  std::vector<bool> is_done(paths.size());
  // Those with a free end begin there; then what is left goes round.
  for (const bool is_round : {false, true}) {
    for (size_t i = 0; i < paths.size(); ++i) {
      if (is_done[i]) continue;
      const bool free_start = links[2 * i] == kNone, free_end = links[2 * i + 1] == kNone;
      if (!is_round && !free_start && !free_end) continue;
      bridged.push_back(follow(paths, links, free_start || is_round ? 2 * i : 2 * i + 1, is_done));
    }
  }
  return bridged;
}

}  // namespace inkbench
