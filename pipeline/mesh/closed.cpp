// SPDX-License-Identifier: MIT
#include "pipeline/mesh/closed.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "pipeline/mesh/triangle_edges.h"
#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

/// Each directed edge once, and its opposite too. Edges are grouped by their smaller point: time in
/// proportion to the mesh.
bool edges_pair_up(const std::vector<Triangle>& triangles, size_t point_count) {
  std::vector<size_t> starts(point_count + 1, 0);
  const auto for_each_edge = [&](const auto& use) {
    for (const Triangle& t : triangles) {
      for (int i = 0; i < 3; ++i) use(t[i], t[(i + 1) % 3]);
    }
  };
  for_each_edge([&](uint32_t from, uint32_t to) { ++starts[std::min(from, to) + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<uint64_t> edges(triangles.size() * 3);  // the larger point and the direction
  std::vector<size_t> filled(starts.begin(), starts.end() - 1);
  for_each_edge([&](uint32_t from, uint32_t to) {
    edges[filled[std::min(from, to)]++] = (uint64_t{std::max(from, to)} << 1) | (from < to ? 0 : 1);
  });
  for (size_t point = 0; point < point_count; ++point) {
    const std::span group(edges.begin() + starts[point], edges.begin() + starts[point + 1]);
    if (group.size() % 2 != 0) return false;
    std::sort(group.begin(), group.end());
    for (size_t i = 0; i < group.size(); i += 2) {
      const bool pair = (group[i] & 1) == 0 && group[i + 1] == group[i] + 1;
      if (!pair || (i > 0 && group[i] == group[i - 2])) return false;
    }
  }
  return true;
}

uint32_t find_root(std::vector<uint32_t>& parent, uint32_t vertex) {
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

bool all_parts_outwards(const std::vector<glm::vec3>& positions, const std::vector<Triangle>& triangles) {
  std::vector<uint32_t> parent(positions.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (const Triangle& t : triangles) {
    for (int i = 1; i < 3; ++i) parent[find_root(parent, t[i])] = find_root(parent, t[0]);
  }
  std::vector<double> volume(positions.size(), 0.0);
  for (const Triangle& t : triangles) {
    const glm::dvec3 a = positions[t[0]];
    volume[find_root(parent, t[0])] +=
        glm::dot(a, glm::cross(glm::dvec3(positions[t[1]]), glm::dvec3(positions[t[2]])));
  }
  return std::all_of(triangles.begin(), triangles.end(),
                     [&](const Triangle& t) { return volume[find_root(parent, t[0])] > 0.0; });
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
  return edges_pair_up(triangles, mesh.positions.size()) && all_parts_outwards(mesh.positions, triangles);
}

}  // namespace inkbench
