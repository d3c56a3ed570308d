// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/collapse_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <numeric>

#include "pipeline/base/text.h"
#include "pipeline/mesh/triangle_edges.h"

namespace inkbench {
namespace {

constexpr uint32_t kLeftOut = CollapseRecord::kLeftOut;
/// Normals nearer than this (cosine, 2.6 degrees) are one; farther apart they make a sharp edge.
constexpr float kSameNormal = 0.999F;
/// More vertices than this at one place are not looked at, so that a million of them cost no quadratic time.
constexpr int kMaxRing = 64;

/// For each point the one that stands for it after `count` collapses. Backwards, since a kept point is
/// removed only later.
std::vector<uint32_t> replay(const CollapseRecord& record, size_t count) {
  std::vector<uint32_t> stands_for(record.origin.size());
  std::iota(stands_for.begin(), stands_for.end(), 0U);
  for (size_t i = count; i-- > 0;) {
    stands_for[record.collapses[i].removed] = stands_for[record.collapses[i].kept];
  }
  return stands_for;
}

bool is_left_out(const Triangle& triangle) {
  return triangle[0] == kLeftOut;
}

/// The triangle after the collapses; a triangle is gone when two of its points are one.
bool survives(const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/// The first vertex at `vertex`'s place whose normal is that of the one that fits `direction` best.
uint32_t best_fitting(const Mesh& mesh, const CollapseRecord& record, uint32_t vertex,
                      const glm::vec3& direction) {
  uint32_t best = vertex;
  float best_fit = glm::dot(mesh.normals[vertex], direction);
  uint32_t other = record.next_equal[vertex];
  for (int i = 0; i < kMaxRing && other != vertex; ++i, other = record.next_equal[other]) {
    const float fit = glm::dot(mesh.normals[other], direction);
    if (fit > best_fit || (fit == best_fit && other < best)) {
      best = other;
      best_fit = fit;
    }
  }
  uint32_t first = best;
  other = record.next_equal[best];
  for (int i = 0; i < kMaxRing && other != best; ++i, other = record.next_equal[other]) {
    if (other < first && glm::dot(mesh.normals[other], mesh.normals[best]) > kSameNormal) first = other;
  }
  return first;
}

/// The mesh's vertices that a surviving triangle uses, where they stand alone at their place or not.
Triangle vertices_of(const Mesh& mesh, const CollapseRecord& record, const Triangle& points, size_t face) {
  Triangle vertices{record.origin[points[0]], record.origin[points[1]], record.origin[points[2]]};
  const bool stand_alone =
      std::ranges::all_of(vertices, [&](uint32_t vertex) { return record.next_equal[vertex] == vertex; });
  if (stand_alone) return vertices;
  const glm::vec3& a = mesh.positions[vertices[0]];
  const glm::vec3 face_normal = glm::cross(mesh.positions[vertices[1]] - a, mesh.positions[vertices[2]] - a);
  for (int i = 0; i < 3; ++i) {
    // A corner that has not moved keeps its own normal.
    const uint32_t own = mesh.triangles[face][i];
    const bool is_own = record.corners[face][i] == points[i];
    vertices[i] =
        best_fitting(mesh, record, is_own ? own : vertices[i], is_own ? mesh.normals[own] : face_normal);
  }
  return vertices;
}

/// Takes over the used vertices of `mesh` in their order and renumbers the triangles.
void take_vertices(const Mesh& mesh, Mesh& level) {
  std::vector<uint32_t> number(mesh.positions.size(), kLeftOut);
  for (const Triangle& t : level.triangles) {
    for (const uint32_t vertex : t) number[vertex] = 0;
  }
  level.positions.reserve(level.triangles.size());
  level.normals.reserve(level.triangles.size());
  for (size_t vertex = 0; vertex < number.size(); ++vertex) {
    if (number[vertex] == kLeftOut) continue;
    number[vertex] = static_cast<uint32_t>(level.positions.size());
    level.positions.push_back(mesh.positions[vertex]);
    level.normals.push_back(mesh.normals[vertex]);
  }
  for (Triangle& t : level.triangles) {
    for (uint32_t& vertex : t) vertex = number[vertex];
  }
}

bool indices_are_good(const CollapseRecord& record, const Mesh& mesh) {
  const auto is_vertex = [&](uint32_t vertex) { return vertex < mesh.positions.size(); };
  if (!std::ranges::all_of(record.origin, is_vertex) || !std::ranges::all_of(record.next_equal, is_vertex))
    return false;
  for (size_t face = 0; face < record.corners.size(); ++face) {
    const Triangle& points = record.corners[face];
    if (points == Triangle{kLeftOut, kLeftOut, kLeftOut}) continue;
    for (int i = 0; i < 3; ++i) {
      if (points[i] >= record.origin.size() ||
          mesh.positions[record.origin[points[i]]] != mesh.positions[mesh.triangles[face][i]])
        return false;
    }
  }
  return true;
}

bool rings_are_good(const CollapseRecord& record, const Mesh& mesh) {
  std::vector<bool> seen(record.next_equal.size(), false);
  for (size_t vertex = 0; vertex < record.next_equal.size(); ++vertex) {
    const uint32_t next = record.next_equal[vertex];
    if (seen[next] || mesh.positions[next] != mesh.positions[vertex]) return false;
    seen[next] = true;
  }
  return true;
}

bool collapses_are_good(const CollapseRecord& record) {
  std::vector<bool> gone(record.origin.size(), false);
  for (size_t i = 0; i < record.collapses.size(); ++i) {
    const auto [removed, kept] = record.collapses[i];
    if (removed >= gone.size() || kept >= gone.size() || removed == kept || gone[removed] || gone[kept])
      return false;
    gone[removed] = true;
    if (record.faces[i + 1] >= record.faces[i]) return false;
  }
  return true;
}

size_t surviving_triangles(const CollapseRecord& record, size_t count) {
  const std::vector<uint32_t> stands_for = replay(record, count);
  return static_cast<size_t>(std::ranges::count_if(record.corners, [&](const Triangle& t) {
    return !is_left_out(t) && survives({stands_for[t[0]], stands_for[t[1]], stands_for[t[2]]});
  }));
}

}  // namespace

size_t collapses_for(const CollapseRecord& record, size_t asked_faces) {
  const auto level =
      std::ranges::partition_point(record.faces, [&](uint32_t faces) { return faces > asked_faces; });
  const auto count = static_cast<size_t>(level - record.faces.begin());
  return std::min(count, record.collapses.size());
}

Mesh mesh_at_level(const Mesh& mesh, const CollapseRecord& record, size_t asked_faces) {
  assert(record.corners.size() == mesh.triangles.size() &&
         record.faces.size() == record.collapses.size() + 1);
  if (asked_faces == 0 || asked_faces >= mesh.triangles.size()) return mesh;
  const size_t count = collapses_for(record, asked_faces);
  const std::vector<uint32_t> stands_for = replay(record, count);
  Mesh level;
  level.notes = mesh.notes;
  level.origin = mesh.origin;
  level.unit = mesh.unit;
  level.has_given_normals = mesh.has_given_normals;
  level.triangles.reserve(record.faces[count]);
  for (size_t face = 0; face < record.corners.size(); ++face) {
    const Triangle& t = record.corners[face];
    if (is_left_out(t)) continue;
    const Triangle points{stands_for[t[0]], stands_for[t[1]], stands_for[t[2]]};
    if (survives(points)) level.triangles.push_back(vertices_of(mesh, record, points, face));
  }
  take_vertices(mesh, level);
  if (level.triangles.size() > asked_faces) {
    level.notes.push_back(fmt::format("Decimation ends at {} faces; {} were asked for.",
                                      with_commas(static_cast<long long>(level.triangles.size())),
                                      with_commas(static_cast<long long>(asked_faces))));
  }
  return level;
}

bool is_record_of(const CollapseRecord& record, const Mesh& mesh) {
  return record.corners.size() == mesh.triangles.size() &&
         record.next_equal.size() == mesh.positions.size() &&
         record.faces.size() == record.collapses.size() + 1 && indices_are_good(record, mesh) &&
         rings_are_good(record, mesh) && collapses_are_good(record) &&
         record.faces.front() == surviving_triangles(record, 0) &&
         record.faces.back() == surviving_triangles(record, record.collapses.size());
}

}  // namespace inkbench
