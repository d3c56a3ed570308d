// SPDX-License-Identifier: MIT
#include "pipeline/lines/line_tracer.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace inkbench {

uint32_t LineTracer::node(const Crossing& crossing) {
  const auto [found, is_new] = node_of_id_.try_emplace(crossing.id, static_cast<uint32_t>(points_.size()));
  if (is_new) {
    points_.push_back(crossing.point);
    strengths_.push_back(crossing.strength);
  }
  return found->second;
}

void LineTracer::add_step(const Crossing& a, const Crossing& b) {
  const uint32_t from = node(a);
  links_.push_back({from, node(b)});
}

void LineTracer::add_runs(const Chain& chain, LineClass line_class, double weak, double shortest,
                          std::vector<Polyline3>& lines) const {
  for (size_t first = 0; first < chain.size(); ++first) {
    size_t last = first;
    double strongest = 0.0;
    double length = 0.0;
    for (; last < chain.size() && strengths_[chain[last]] >= weak; ++last) {
      strongest = std::max(strongest, strengths_[chain[last]]);
      if (last > first) length += glm::length(points_[chain[last]] - points_[chain[last - 1]]);
    }
    if (strongest >= 1.0 && last > first + 1 && length >= shortest) {
      Polyline3 line{line_class, {}};
      for (size_t i = first; i < last; ++i) line.points.push_back(points_[chain[i]]);
      lines.push_back(std::move(line));
    }
    first = last;
  }
}

std::vector<Polyline3> LineTracer::lines(LineClass line_class, double weak, double shortest) const {
  constexpr double kMaxTurnDeg = 60.0;
  std::vector<Polyline3> lines;
  for (Chain& chain : chain_links(points_, links_, kMaxTurnDeg)) {
    if (chain.size() > 2 && chain.front() == chain.back()) {
      // A closed chain starts at its weakest point, so that a run across its start is not cut there.
      chain.pop_back();
      std::rotate(chain.begin(),
                  std::min_element(chain.begin(), chain.end(),
                                   [&](uint32_t a, uint32_t b) { return strengths_[a] < strengths_[b]; }),
                  chain.end());
      chain.push_back(chain.front());
    }
    add_runs(chain, line_class, weak, shortest, lines);
  }
  return lines;
}

}  // namespace inkbench
