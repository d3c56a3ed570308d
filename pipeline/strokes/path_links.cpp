// SPDX-License-Identifier: MIT
#include "pipeline/strokes/path_links.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

namespace inkbench {
namespace {

/// Over this length an end's direction is looked at.
constexpr float kDirectionPx = 6.0F;
constexpr size_t kNone = std::numeric_limits<size_t>::max();

/// For each end the one that it is linked to, or `kNone`.
std::vector<size_t> partners(size_t ends, std::vector<PathLink> links) {
  std::sort(links.begin(), links.end(), [](const PathLink& a, const PathLink& b) {
    return std::tie(a.cost, a.a, a.b) < std::tie(b.cost, b.a, b.b);
  });
  std::vector<size_t> partner(ends, kNone);
  for (const PathLink& link : links) {
    if (partner[link.a] != kNone || partner[link.b] != kNone) continue;
    partner[link.a] = link.b;
    partner[link.b] = link.a;
  }
  return partner;
}

/// The chain of paths that begins with the end `entry`.
StrokePath follow(const std::vector<StrokePath>& paths, const std::vector<size_t>& partner, size_t entry,
                  std::vector<bool>& is_done, const PutBehind& put_behind, const Close& close) {
  StrokePath chain;
  for (size_t at = entry;;) {
    const StrokePath& path = paths[at / 2];
    is_done[at / 2] = true;
    const StrokePath next = at % 2 == 0 ? path : reversed(path);
    if (chain.points.empty())
      chain = next;
    else
      put_behind(chain, next);
    at = partner[at ^ 1U];
    if (at == kNone) return chain;
    if (at == entry) {
      close(chain);
      return chain;
    }
  }
}

}  // namespace

PathEnd end_of(const StrokePath& path, size_t number) {
  const bool is_start = number % 2 == 0;
  const PathPoint& end = is_start ? path.points.front() : path.points.back();
  const float back = std::min(kDirectionPx, length_px(path));
  const glm::vec2 away = end.at - point_at(path, is_start ? end.along_px + back : end.along_px - back).at;
  const float length = glm::length(away);
  return {number, end.at, length > 0.0F ? away / length : glm::vec2(0.0F)};
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

std::vector<PathLink> links_between(const std::vector<StrokePath>& paths, float reach_px,
                                    const std::function<float(const PathEnd& a, const PathEnd& b)>& cost) {
  const std::vector<PathEnd> ends = open_ends(paths);
  std::vector<PathLink> links;
  for (size_t i = 0; i < ends.size(); ++i) {
    for (size_t j = i + 1; j < ends.size() && ends[j].at.x - ends[i].at.x <= reach_px; ++j) {
      if (std::abs(ends[j].at.y - ends[i].at.y) > reach_px) continue;
      if (!may_be_one(paths[ends[i].path()], paths[ends[j].path()])) continue;
      const bool in_order = ends[i].number < ends[j].number;
      const PathEnd &a = in_order ? ends[i] : ends[j], &b = in_order ? ends[j] : ends[i];
      const float link_cost = cost(a, b);
      if (link_cost >= 0.0F) links.push_back({link_cost, a.number, b.number});
    }
  }
  return links;
}

std::vector<StrokePath> linked(const std::vector<StrokePath>& paths, std::vector<PathLink> links,
                               const PutBehind& put_behind, const Close& close) {
  const std::vector<size_t> partner = partners(2 * paths.size(), std::move(links));
  std::vector<StrokePath> result;
  std::vector<bool> is_done(paths.size());
  // Those with a free end begin there; then what is left goes round.
  for (const bool is_round : {false, true}) {
    for (size_t i = 0; i < paths.size(); ++i) {
      const bool free_start = partner[2 * i] == kNone, free_end = partner[2 * i + 1] == kNone;
      if (is_done[i] || (!is_round && !free_start && !free_end)) continue;
      const size_t entry = free_start || is_round ? 2 * i : 2 * i + 1;
      result.push_back(follow(paths, partner, entry, is_done, put_behind, close));
    }
  }
  return result;
}

void unite(StrokePath& path, const StrokePath& next) {
  if (length_px(next) > length_px(path)) path.is_outline = next.is_outline;
  path.end = next.end;
  path.covered = std::min(path.covered, next.covered);
  path.number = std::min(path.number, next.number);
}

void close_path(StrokePath& path) {
  path.points.back().at = path.points.front().at;
  path.is_closed = true;
  path.start = path.end = CurveEnd::closed;
}

}  // namespace inkbench
