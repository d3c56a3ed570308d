// SPDX-License-Identifier: MIT
#include "pipeline/lines/chain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <tuple>

namespace inkbench {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
constexpr size_t kCrowd = 32;

/// End `end` of link `link` is 2 link + end.
using End = uint32_t;

class Chainer {
 public:
  Chainer(std::span<const glm::dvec3> positions, std::span<const Link> links, double max_turn_deg)
      : positions_(positions),
        links_(links),
        min_cosine_(max_turn_deg >= 180.0 ? -2.0 : std::cos(glm::radians(max_turn_deg))),
        partner_(links.size() * 2, kNone),
        done_(links.size(), 0) {}

  std::vector<LinkedChain> chains() {
    pair_ends();
    std::vector<LinkedChain> result;
    for (End end = 0; end < partner_.size(); ++end) {
      if (partner_[end] == kNone && done_[end / 2] == 0) result.push_back(walk_from(end));
    }
    for (End end = 0; end < partner_.size(); end += 2) {
      if (done_[end / 2] == 0) result.push_back(walk_from(end));
    }
    return result;
  }

 private:
  uint32_t point_at(End end) const { return links_[end / 2][end % 2]; }

  /// Cosine of the turn from one end's link into the other's, at the point where both meet.
  double straightness(End a, End b) const {
    const glm::dvec3& middle = positions_[point_at(a)];
    const glm::dvec3 in = middle - positions_[point_at(a ^ 1U)];
    const glm::dvec3 out = positions_[point_at(b ^ 1U)] - middle;
    const double lengths = glm::length(in) * glm::length(out);
    return lengths > 0.0 ? glm::dot(in, out) / lengths : 1.0;
  }

  void join(End a, End b) {
    partner_[a] = b;
    partner_[b] = a;
  }

  void pair_ends() {
    // By point, then in order: both in one number, which sorts quickest.
    std::vector<uint64_t> ends(partner_.size());
    for (End end = 0; end < ends.size(); ++end) ends[end] = (uint64_t{point_at(end)} << 32) | end;
    std::sort(ends.begin(), ends.end());
    std::vector<End> meeting;
    for (size_t first = 0; first < ends.size();) {
      size_t last = first;
      meeting.clear();
      for (; last < ends.size() && ends[last] >> 32 == ends[first] >> 32; ++last)
        meeting.push_back(static_cast<End>(ends[last]));
      if (meeting.size() == 2) join(meeting[0], meeting[1]);
      if (meeting.size() > 2 && meeting.size() <= kCrowd) pair_straightest(meeting);
      first = last;
    }
  }

  void pair_straightest(std::span<const End> meeting) {
    std::vector<std::tuple<double, End, End>> pairs;
    for (size_t i = 0; i < meeting.size(); ++i) {
      for (size_t j = i + 1; j < meeting.size(); ++j) {
        const double cosine = straightness(meeting[i], meeting[j]);
        if (cosine >= min_cosine_) pairs.emplace_back(-cosine, meeting[i], meeting[j]);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [bend, a, b] : pairs) {
      if (partner_[a] == kNone && partner_[b] == kNone) join(a, b);
    }
  }

  /// From an end along its link and on, until a chain ends or is back at the start.
  LinkedChain walk_from(End end) {
    LinkedChain chain{{point_at(end)}, {}};
    while (end != kNone && done_[end / 2] == 0) {
      done_[end / 2] = 1;
      chain.points.push_back(point_at(end ^ 1U));
      chain.links.push_back(end / 2);
      end = partner_[end ^ 1U];
    }
    return chain;
  }

  std::span<const glm::dvec3> positions_;
  std::span<const Link> links_;
  double min_cosine_;
  std::vector<End> partner_;
  std::vector<uint8_t> done_;
};

}  // namespace

std::vector<LinkedChain> linked_chains(std::span<const glm::dvec3> positions, std::span<const Link> links,
                                       double max_turn_deg) {
  return Chainer(positions, links, max_turn_deg).chains();
}

std::vector<Chain> chain_links(std::span<const glm::dvec3> positions, std::span<const Link> links,
                               double max_turn_deg) {
  std::vector<Chain> chains;
  for (LinkedChain& chain : linked_chains(positions, links, max_turn_deg))
    chains.push_back(std::move(chain.points));
  return chains;
}

}  // namespace inkbench
