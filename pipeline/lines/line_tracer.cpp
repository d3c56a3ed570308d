// SPDX-License-Identifier: MIT
#include "pipeline/lines/line_tracer.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace inkbench {

LineTracer::Crossing LineTracer::middle(uint32_t id, const std::array<Crossing, 3>& crossings) {
  Crossing middle{id, glm::dvec3(0.0), 0.0};
  for (const Crossing& crossing : crossings) {
    middle.point += crossing.point / 3.0;
    middle.strength += crossing.strength / 3.0;
  }
  return middle;
}

uint32_t LineTracer::node(const Crossing& crossing) {
  uint32_t& node = node_of_id_[crossing.id];
  if (node == kNoNode) {
    node = static_cast<uint32_t>(points_.size());
    ids_.push_back(crossing.id);
    points_.push_back(crossing.point);
    strengths_.push_back(crossing.strength);
  }
  return node;
}

void LineTracer::add_step(uint32_t face, const Crossing& a, const Crossing& b) {
  const uint32_t from = node(a);
  links_.push_back({from, node(b)});
  faces_.push_back(face);
}

SurfaceLine LineTracer::line(const LinkedChain& chain, size_t first, size_t last) const {
  SurfaceLine line;
  for (size_t i = first; i < last; ++i) {
    line.points.push_back(points_[chain.points[i]]);
    line.crossings.push_back(ids_[chain.points[i]]);
    if (i + 1 < last) line.faces.push_back(faces_[chain.links[i]]);
  }
  return line;
}

void LineTracer::add_runs(const LinkedChain& chain, double weak, double shortest,
                          std::vector<SurfaceLine>& lines) const {
  const Chain& nodes = chain.points;
  for (size_t first = 0; first < nodes.size(); ++first) {
    size_t last = first;
    double strongest = 0.0;
    double length = 0.0;
    for (; last < nodes.size() && strengths_[nodes[last]] >= weak; ++last) {
      strongest = std::max(strongest, strengths_[nodes[last]]);
      if (last > first) length += glm::length(points_[nodes[last]] - points_[nodes[last - 1]]);
    }
    if (strongest >= 1.0 && last > first + 1 && length >= shortest) lines.push_back(line(chain, first, last));
    first = last;
  }
}

std::vector<SurfaceLine> LineTracer::lines(double weak, double shortest) const {
  std::vector<SurfaceLine> lines;
  for (LinkedChain& chain : linked_chains(points_, links_, kMaxTurnDeg)) {
    Chain& nodes = chain.points;
    if (nodes.size() > 2 && nodes.front() == nodes.back()) {
      // A closed chain starts at its weakest point, so that a run across its start is not cut there.
      nodes.pop_back();
      const auto weakest = std::min_element(
          nodes.begin(), nodes.end(), [&](uint32_t a, uint32_t b) { return strengths_[a] < strengths_[b]; });
      std::rotate(chain.links.begin(), chain.links.begin() + (weakest - nodes.begin()), chain.links.end());
      std::rotate(nodes.begin(), weakest, nodes.end());
      nodes.push_back(nodes.front());
    }
    add_runs(chain, weak, shortest, lines);
  }
  return lines;
}

std::vector<Polyline3> of_class(LineClass line_class, std::vector<SurfaceLine> lines) {
  std::vector<Polyline3> result;
  result.reserve(lines.size());
  for (SurfaceLine& line : lines)
    result.push_back({line_class, std::move(line.points), std::move(line.crossings), std::move(line.faces)});
  return result;
}

}  // namespace inkbench
