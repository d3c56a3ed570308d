// SPDX-License-Identifier: MIT
#include "pipeline/mesh/closed.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "pipeline/mesh/triangle_edges.h"
#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

/// Each directed edge once, and its opposite too.
bool edges_pair_up(const std::vector<EdgeUse>& uses) {
  bool all = true;
  for_each_edge(uses, [&](size_t begin, size_t end) {
    all = all && end - begin == 2 && uses[begin].is_rising != uses[begin + 1].is_rising;
  });
  return all;
}

bool all_parts_outwards(const std::vector<glm::vec3>& positions, const std::vector<Triangle>& triangles) {
  Forest parts(positions.size());
  for (const Triangle& t : triangles) {
    for (int i = 1; i < 3; ++i) parts.join(t[0], t[i]);
  }
  std::vector<double> volume(positions.size(), 0.0);
  for (const Triangle& t : triangles) {
    const glm::dvec3 a = positions[t[0]];
    volume[parts.root(t[0])] +=
        glm::dot(a, glm::cross(glm::dvec3(positions[t[1]]), glm::dvec3(positions[t[2]])));
  }
  return std::all_of(triangles.begin(), triangles.end(),
                     [&](const Triangle& t) { return volume[parts.root(t[0])] > 0.0; });
}

}  // namespace

bool is_closed_outwards(const Mesh& mesh) {
  const std::vector<uint32_t> first = first_at_same_position(mesh.positions);
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Triangle welded{first[t[0]], first[t[1]], first[t[2]]};
    const bool is_area = welded[0] != welded[1] && welded[1] != welded[2] && welded[2] != welded[0];
    if (is_area) triangles.push_back(welded);
  }
  return edges_pair_up(sorted_edges(triangles, mesh.positions.size())) &&
         all_parts_outwards(mesh.positions, triangles);
}

}  // namespace inkbench
