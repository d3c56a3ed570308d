// SPDX-License-Identifier: MIT
#include "pipeline/lines/topology.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "pipeline/lines/covered_borders.h"
#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

using Face = std::array<uint32_t, 3>;

/// The points that faces use get indices in order of their first vertex; faces keep their order.
void weld_faces(const Mesh& mesh, MeshTopology& topology) {
  constexpr uint32_t kUnused = std::numeric_limits<uint32_t>::max();
  const std::vector<uint32_t> first = first_at_same_position(mesh.positions);
  std::vector<uint32_t> point_of(mesh.positions.size(), kUnused);
  std::vector<uint8_t> used(mesh.positions.size(), 0);
  topology.faces.reserve(mesh.triangles.size());
  for (const Face& triangle : mesh.triangles) {
    const Face face{first[triangle[0]], first[triangle[1]], first[triangle[2]]};
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
    topology.faces.push_back(face);
    for (const uint32_t point : face) used[point] = 1;
  }
  for (size_t vertex = 0; vertex < used.size(); ++vertex) {
    if (used[vertex] == 0) continue;
    point_of[vertex] = static_cast<uint32_t>(topology.positions.size());
    topology.positions.emplace_back(mesh.positions[vertex]);
  }
  for (Face& face : topology.faces) {
    for (uint32_t& point : face) point = point_of[point];
  }
}

/// The face turned so that its smallest point comes first: equal for equal faces.
Face turned(const Face& face) {
  const auto smallest = static_cast<size_t>(std::min_element(face.begin(), face.end()) - face.begin());
  return {face[smallest], face[(smallest + 1) % 3], face[(smallest + 2) % 3]};
}

/// Start of each group when things are grouped by a key below `keys`: counts turned into running sums.
std::vector<uint32_t> group_starts(const std::vector<uint32_t>& counts) {
  std::vector<uint32_t> starts(counts.size() + 1, 0);
  for (size_t i = 0; i < counts.size(); ++i) starts[i + 1] = starts[i] + counts[i];
  return starts;
}

void drop_repeated_faces(MeshTopology& topology) {
  std::vector<uint32_t> counts(topology.positions.size(), 0);
  for (const Face& face : topology.faces) ++counts[turned(face)[0]];
  const std::vector<uint32_t> starts = group_starts(counts);
  std::vector<uint32_t> filled = starts;
  std::vector<uint32_t> grouped(topology.faces.size());
  for (uint32_t f = 0; f < topology.faces.size(); ++f) grouped[filled[turned(topology.faces[f])[0]]++] = f;
  std::vector<uint8_t> repeated(topology.faces.size(), 0);
  for (size_t point = 0; point + 1 < starts.size(); ++point) {
    const auto begin = grouped.begin() + starts[point];
    const auto end = grouped.begin() + starts[point + 1];
    std::sort(begin, end, [&](uint32_t a, uint32_t b) {
      const Face left = turned(topology.faces[a]);
      const Face right = turned(topology.faces[b]);
      return left == right ? a < b : left < right;
    });
    for (auto i = begin; i != end; ++i) {
      if (i != begin && turned(topology.faces[*i]) == turned(topology.faces[*(i - 1)])) repeated[*i] = 1;
    }
  }
  size_t kept = 0;
  for (size_t f = 0; f < topology.faces.size(); ++f) {
    if (repeated[f] == 0) topology.faces[kept++] = topology.faces[f];
  }
  topology.faces.resize(kept);
}

/// Corner `corner` of a face as a half edge: its other end, and where it comes from.
struct HalfEdge {
  uint32_t larger_point, face, corner;
};

void find_edges(MeshTopology& topology) {
  std::vector<uint32_t> counts(topology.positions.size(), 0);
  for (const Face& face : topology.faces) {
    for (size_t i = 0; i < 3; ++i) ++counts[std::min(face[i], face[(i + 1) % 3])];
  }
  const std::vector<uint32_t> starts = group_starts(counts);
  std::vector<uint32_t> filled = starts;
  std::vector<HalfEdge> halves(topology.faces.size() * 3);
  for (uint32_t f = 0; f < topology.faces.size(); ++f) {
    const Face& face = topology.faces[f];
    for (uint32_t i = 0; i < 3; ++i) {
      const auto [smaller, larger] = std::minmax(face[i], face[(i + 1) % 3]);
      halves[filled[smaller]++] = {larger, f, i};
    }
  }
  topology.face_edges.resize(topology.faces.size());
  topology.uses.reserve(halves.size());
  for (uint32_t point = 0; point + 1 < starts.size(); ++point) {
    const auto begin = halves.begin() + starts[point];
    const auto end = halves.begin() + starts[point + 1];
    std::sort(begin, end, [](const HalfEdge& a, const HalfEdge& b) {
      return a.larger_point == b.larger_point ? a.face < b.face : a.larger_point < b.larger_point;
    });
    for (auto half = begin; half != end; ++half) {
      if (half == begin || half->larger_point != (half - 1)->larger_point) {
        topology.edges.push_back(
            {{point, half->larger_point}, static_cast<uint32_t>(topology.uses.size()), 0});
      }
      ++topology.edges.back().use_count;
      topology.uses.push_back({half->face, topology.faces[half->face][half->corner] == point});
      topology.face_edges[half->face][half->corner] = static_cast<uint32_t>(topology.edges.size() - 1);
    }
  }
}

/// The corner at which the longest edge of a face starts.
size_t longest_edge(const MeshTopology& topology, uint32_t face) {
  std::array<double, 3> lengths{};
  for (size_t i = 0; i < 3; ++i) {
    lengths[i] = glm::length(topology.positions[topology.faces[face][(i + 1) % 3]] -
                             topology.positions[topology.faces[face][i]]);
  }
  return static_cast<size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
}

/// The normal of the face onto which a flat one collapses, or of the one onto which that collapses, and so
/// on. 0 where the way ends at a boundary or turns in a circle.
glm::dvec3 borrowed_normal(const MeshTopology& topology, uint32_t face) {
  constexpr int kLongestWay = 64;
  bool against = false;
  for (int step = 0; step < kLongestWay; ++step) {
    const MeshTopology::Edge& edge = topology.edges[topology.face_edges[face][longest_edge(topology, face)]];
    const auto uses = topology.uses_of(edge);
    if (uses.size() != 2) return glm::dvec3(0.0);
    const size_t other = uses[0].face == face ? 1 : 0;
    against ^= !consistent(uses[0], uses[1]);
    face = uses[other].face;
    if (topology.normals[face] != glm::dvec3(0.0)) return topology.normals[face] * (against ? -1.0 : 1.0);
  }
  return glm::dvec3(0.0);
}

void find_normals(MeshTopology& topology) {
  std::vector<uint32_t> flat;
  topology.normals.reserve(topology.faces.size());
  for (uint32_t f = 0; f < topology.faces.size(); ++f) {
    const Face& face = topology.faces[f];
    const glm::dvec3& origin = topology.positions[face[0]];
    const glm::dvec3 normal =
        glm::cross(topology.positions[face[1]] - origin, topology.positions[face[2]] - origin);
    const double length = glm::length(normal);
    topology.normals.push_back(length > 0.0 ? normal / length : glm::dvec3(0.0));
    if (!(length > 0.0)) flat.push_back(f);
  }
  std::vector<glm::dvec3> borrowed;
  for (const uint32_t f : flat) borrowed.push_back(borrowed_normal(topology, f));
  for (size_t i = 0; i < flat.size(); ++i) topology.normals[flat[i]] = borrowed[i];
}

}  // namespace

MeshTopology make_topology(const Mesh& mesh) {
  MeshTopology topology;
  weld_faces(mesh, topology);
  drop_repeated_faces(topology);
  find_edges(topology);
  find_normals(topology);
  topology.cover_angles_deg = cover_angles(topology);
  return topology;
}

}  // namespace inkbench
