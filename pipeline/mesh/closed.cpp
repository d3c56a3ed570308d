#include "pipeline/mesh/closed.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

using Triangle = std::array<uint32_t, 3>;

uint64_t directed_edge(uint32_t from, uint32_t to) {
  return (static_cast<uint64_t>(from) << 32) | to;
}

/// Each directed edge once, and its opposite too.
bool edges_pair_up(const std::vector<Triangle>& triangles) {
  std::vector<uint64_t> edges;
  edges.reserve(triangles.size() * 3);
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) edges.push_back(directed_edge(t[i], t[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  return std::all_of(edges.begin(), edges.end(), [&](uint64_t edge) {
    return std::binary_search(edges.begin(), edges.end(), (edge << 32) | (edge >> 32));
  });
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
  std::vector<Triangle> triangles = mesh.triangles;
  for (Triangle& t : triangles) {
    for (uint32_t& corner : t) corner = first[corner];
  }
  return edges_pair_up(triangles) && all_parts_outwards(mesh.positions, triangles);
}

}  // namespace inkbench
