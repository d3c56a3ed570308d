// SPDX-License-Identifier: MIT
#include "pipeline/mesh/weld.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

/// Three whole numbers, held as doubles since a tiny tolerance leaves the range of integers.
using Cell = std::array<double, 3>;

uint64_t hash_of(const Cell& cell) {
  uint64_t hash = 0x9e3779b97f4a7c15ULL;
  for (const double coordinate : cell) {
    // Adding zero turns -0 into +0, which compares equal and must hash equal.
    hash = (hash ^ std::bit_cast<uint64_t>(coordinate + 0.0)) * 0xff51afd7ed558ccdULL;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Vertices chained by the hash of their cell.
class CellTable {
 public:
  explicit CellTable(size_t vertices)
      : heads_(std::bit_ceil(std::max<size_t>(vertices, 1) * 2), kNone), next_(vertices, kNone) {}

  void insert(const Cell& cell, uint32_t vertex) {
    uint32_t& head = heads_[slot(cell)];
    next_[vertex] = head;
    head = vertex;
  }

  /// Calls `visit(vertex)` for all that share the cell's slot, which may hold other cells' too.
  template <class Visit>
  void visit(const Cell& cell, Visit&& visit) const {
    for (uint32_t vertex = heads_[slot(cell)]; vertex != kNone; vertex = next_[vertex]) visit(vertex);
  }

 private:
  size_t slot(const Cell& cell) const { return hash_of(cell) & (heads_.size() - 1); }

  std::vector<uint32_t> heads_;
  std::vector<uint32_t> next_;
};

/// The mean of normals, or the first where they cancel.
glm::vec3 mean_normal(const glm::dvec3& sum, const glm::vec3& first) {
  const double length = glm::length(sum);
  return length > 1e-6 ? glm::vec3(sum / length) : first;
}

/// Calls `use(cell)` for each cell between two that are the same or neighbours along each axis.
template <class Use>
void for_each_cell(const Cell& low, const Cell& high, Use&& use) {
  for (int i = 0; i < 8; ++i) {
    Cell cell = low;
    bool is_new = true;
    for (int axis = 0; axis < 3; ++axis) {
      if ((i >> axis & 1) == 0) continue;
      is_new = is_new && high[axis] != low[axis];
      cell[axis] = high[axis];
    }
    if (is_new) use(cell);
  }
}

}  // namespace

std::vector<uint32_t> first_within(const std::vector<glm::vec3>& positions, double tolerance) {
  // Wide enough that most positions have only their own cell within the tolerance, narrow enough that even
  // positions as dense as can be stay few in one.
  const double side = 8 * tolerance;
  const auto cell_of = [&](const glm::dvec3& p) {
    return Cell{std::floor(p.x / side), std::floor(p.y / side), std::floor(p.z / side)};
  };
  CellTable table(positions.size());
  std::vector<uint32_t> first(positions.size());
  for (uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
    first[vertex] = vertex;
    if (!is_finite(positions[vertex])) continue;
    const glm::dvec3 position = positions[vertex];
    for_each_cell(cell_of(position - tolerance), cell_of(position + tolerance), [&](const Cell& cell) {
      table.visit(cell, [&](uint32_t other) {
        const glm::dvec3 gap = position - glm::dvec3(positions[other]);
        if (glm::dot(gap, gap) <= tolerance * tolerance) first[vertex] = std::min(first[vertex], other);
      });
    });
    if (first[vertex] == vertex) table.insert(cell_of(position), vertex);
  }
  return first;
}

std::vector<uint32_t> first_at_same_position(const std::vector<glm::vec3>& positions) {
  CellTable table(positions.size());
  std::vector<uint32_t> first(positions.size());
  for (uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
    const glm::vec3& p = positions[vertex];
    const Cell cell{p.x, p.y, p.z};
    uint32_t found = vertex;
    table.visit(cell, [&](uint32_t other) {
      if (positions[other] == p) found = other;
    });
    first[vertex] = found;
    if (found == vertex) table.insert(cell, vertex);
  }
  return first;
}

WeldResult weld(const Mesh& mesh, float tolerance) {
  if (!(tolerance >= 0.0F) || !std::isfinite(tolerance))
    throw input_error("weld", "bad tolerance " + shortest(tolerance), "0 or more, in the mesh's units");
  const std::vector<uint32_t> first = tolerance == 0.0F ? first_at_same_position(mesh.positions)
                                                        : first_within(mesh.positions, tolerance / mesh.unit);
  WeldResult result;
  Mesh& welded = result.mesh;
  std::vector<uint32_t> renumbered(first.size(), kNone);
  std::vector<glm::dvec3> sums;
  for (uint32_t vertex = 0; vertex < first.size(); ++vertex) {
    if (first[vertex] == vertex) {
      renumbered[vertex] = static_cast<uint32_t>(welded.positions.size());
      welded.positions.push_back(mesh.positions[vertex]);
      welded.normals.push_back(mesh.normals[vertex]);
      sums.emplace_back(0.0);
    } else {
      renumbered[vertex] = renumbered[first[vertex]];
      ++result.merged_vertices;
    }
    sums[renumbered[vertex]] += glm::dvec3(mesh.normals[vertex]);
  }
  for (size_t i = 0; i < sums.size(); ++i) welded.normals[i] = mean_normal(sums[i], welded.normals[i]);
  for (const auto& t : mesh.triangles) {
    const std::array<uint32_t, 3> corners{renumbered[t[0]], renumbered[t[1]], renumbered[t[2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      ++result.dropped_triangles;
    } else {
      welded.triangles.push_back(corners);
    }
  }
  welded.notes = mesh.notes;
  welded.origin = mesh.origin;
  welded.unit = mesh.unit;
  welded.has_given_normals = mesh.has_given_normals;
  if (result.merged_vertices > 0) {
    welded.notes.push_back(fmt::format(
        "Merged {} into others at the same place{}.", counted(result.merged_vertices, "vertex", "vertices"),
        result.dropped_triangles == 0
            ? ""
            : ", which left " + counted(result.dropped_triangles, "triangle", "triangles") +
                  " without area, dropped"));
  }
  return result;
}

}  // namespace inkbench
