// SPDX-License-Identifier: MIT
#include "pipeline/lines/covered_borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <unordered_map>

namespace inkbench {
namespace {

constexpr double kShareOfDiagonal = 1e-6;

/// The part of an edge that another border lies on, along it from 0 to its length.
struct Cover {
  double angle_deg, from, to;
};

/// The ends of borders, by cells of a grid.
class BorderPoints {
 public:
  BorderPoints(const MeshTopology& topology, const std::vector<uint32_t>& borders, double tolerance)
      : topology_(topology) {
    for (const uint32_t edge : borders) {
      for (const uint32_t point : topology.edges[edge].points) borders_at_[point].push_back(edge);
    }
    double length = 0.0;
    for (const uint32_t edge : borders) length += edge_length(edge);
    side_ = std::max(length / static_cast<double>(borders.size()), 4.0 * tolerance);
    for (const auto& [point, edges] : borders_at_)
      cells_[cell_of(topology.positions[point])].push_back(point);
  }

  double edge_length(uint32_t edge) const {
    const auto [a, b] = topology_.edges[edge].points;
    return glm::length(topology_.positions[b] - topology_.positions[a]);
  }

  /// The other borders with an end in a cell that the edge passes.
  std::vector<uint32_t> near(uint32_t edge) const {
    const auto [a, b] = topology_.edges[edge].points;
    const glm::dvec3 from = topology_.positions[a], step = topology_.positions[b] - from;
    const int steps = static_cast<int>(std::ceil(glm::length(step) / side_));
    std::vector<uint32_t> found;
    for (int i = 0; i <= steps; ++i) {
      const Cell middle = cell_of(from + step * (static_cast<double>(i) / std::max(steps, 1)));
      for (int j = 0; j < 27; ++j) {
        const auto cell =
            cells_.find({middle[0] + j % 3 - 1, middle[1] + j / 3 % 3 - 1, middle[2] + j / 9 - 1});
        if (cell == cells_.end()) continue;
        for (const uint32_t point : cell->second) {
          for (const uint32_t other : borders_at_.at(point)) {
            if (other != edge) found.push_back(other);
          }
        }
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  using Cell = std::array<int64_t, 3>;
  struct Hash {
    size_t operator()(const Cell& cell) const {
      uint64_t hash = 0x9e3779b97f4a7c15ULL;
      for (const int64_t part : cell) hash = (hash ^ static_cast<uint64_t>(part)) * 0xff51afd7ed558ccdULL;
      return hash ^ hash >> 32;
    }
  };

  Cell cell_of(const glm::dvec3& place) const {
    return {std::llround(place.x / side_), std::llround(place.y / side_), std::llround(place.z / side_)};
  }

  const MeshTopology& topology_;
  double side_ = 1.0;
  std::unordered_map<uint32_t, std::vector<uint32_t>> borders_at_;
  std::unordered_map<Cell, std::vector<uint32_t>, Hash> cells_;
};

/// Between the faces of two borders: as if both turned the same way.
double face_angle_deg(const MeshTopology& topology, uint32_t edge, uint32_t other, bool runs_along) {
  const MeshTopology::Use& a = topology.uses_of(topology.edges[edge])[0];
  const MeshTopology::Use& b = topology.uses_of(topology.edges[other])[0];
  const bool is_consistent = runs_along ? a.forward != b.forward : a.forward == b.forward;
  const double cosine = glm::dot(topology.normals[a.face], topology.normals[b.face]);
  return glm::degrees(std::acos(std::clamp(is_consistent ? cosine : -cosine, -1.0, 1.0)));
}

std::vector<Cover> covers_of(const MeshTopology& topology, const BorderPoints& points, uint32_t edge,
                             double tolerance) {
  const auto [a, b] = topology.edges[edge].points;
  const glm::dvec3 from = topology.positions[a];
  const double length = points.edge_length(edge);
  if (!(length > tolerance)) return {};
  const glm::dvec3 along = (topology.positions[b] - from) / length;
  std::vector<Cover> covers;
  for (const uint32_t other : points.near(edge)) {
    const auto [c, d] = topology.edges[other].points;
    const glm::dvec3 start = topology.positions[c] - from,
                     step = topology.positions[d] - topology.positions[c];
    const double t0 = glm::dot(start, along), t1 = glm::dot(start + step, along);
    const double low = std::max(0.0, std::min(t0, t1)), high = std::min(length, std::max(t0, t1));
    if (!(high - low > tolerance)) continue;
    const auto distance_at = [&](double t) {
      const glm::dvec3 place = start + step * ((t - t0) / (t1 - t0));
      return glm::length(place - along * t);
    };
    if (std::max(distance_at(low), distance_at(high)) > tolerance) continue;
    covers.push_back({face_angle_deg(topology, edge, other, t1 > t0), low, high});
  }
  return covers;
}

bool reach_across(std::vector<Cover> covers, double length, double tolerance) {
  std::ranges::sort(covers, {}, &Cover::from);
  double reached = 0.0;
  for (const Cover& cover : covers) {
    if (cover.from > reached + tolerance) return false;
    reached = std::max(reached, cover.to);
  }
  return reached >= length - tolerance;
}

double cover_angle(std::vector<Cover> covers, double length, double tolerance) {
  std::ranges::sort(covers, {}, &Cover::angle_deg);
  for (size_t count = 1; count <= covers.size(); ++count) {
    if (reach_across({covers.begin(), covers.begin() + static_cast<ptrdiff_t>(count)}, length, tolerance))
      return covers[count - 1].angle_deg;
  }
  return kUncovered;
}

}  // namespace

std::vector<double> cover_angles(const MeshTopology& topology) {
  std::vector<double> angles(topology.edges.size(), kUncovered);
  std::vector<uint32_t> borders;
  for (uint32_t edge = 0; edge < angles.size(); ++edge) {
    if (topology.edges[edge].use_count == 1) borders.push_back(edge);
  }
  if (borders.empty()) return angles;
  glm::dvec3 low = topology.positions[0], high = low;
  for (const glm::dvec3& position : topology.positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  const double tolerance = kShareOfDiagonal * glm::length(high - low);
  const BorderPoints points(topology, borders, tolerance);
  for (const uint32_t edge : borders) {
    angles[edge] =
        cover_angle(covers_of(topology, points, edge, tolerance), points.edge_length(edge), tolerance);
  }
  return angles;
}

}  // namespace inkbench
