// SPDX-License-Identifier: MIT
#include "pipeline/curves/surface_cuts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace inkbench {
namespace {

using Face = std::array<uint32_t, 3>;

/// A mesh with its points in the first mesh's space.
struct PlacedMesh {
  const MeshTopology* topology = nullptr;
  const std::vector<uint8_t>* drawn_edges = nullptr;
  const std::vector<glm::dvec3>* points = nullptr;

  const glm::dvec3& point(uint32_t index) const { return (*points)[index]; }
};

/// Six times the volume of the tetrahedron from a line, p to q, and an edge, whose sign says on which side of
/// each other they pass. Worked out from the edge's smaller point on, so that faces which share it agree.
bool passes_left(const glm::dvec3& p, const glm::dvec3& q, const PlacedMesh& mesh, uint32_t from,
                 uint32_t to) {
  const bool forward = from < to;
  const glm::dvec3& a = mesh.point(std::min(from, to));
  const glm::dvec3& b = mesh.point(std::max(from, to));
  const double volume = glm::dot(q - p, glm::cross(a - p, b - p));
  return forward ? volume >= 0.0 : !(volume >= 0.0);
}

class Cutter {
 public:
  Cutter(const PlacedMesh& first, const PlacedMesh& second, double on_plane)
      : meshes_{first, second}, is_one_(first.points == second.points), on_plane_(on_plane) {}

  void cut(uint32_t first_face, uint32_t second_face) {
    const std::array<double, 3> of_second = distances(1, second_face, first_face);
    if (on_one_side(of_second)) return;
    const std::array<double, 3> of_first = distances(0, first_face, second_face);
    if (on_one_side(of_first)) return;
    found_.clear();
    pierce(0, first_face, of_first, second_face);
    pierce(1, second_face, of_second, first_face);
    // Of a face that lies in the other's plane more is found; nobody can say where those cut.
    if (found_.size() != 2 || found_[0] == found_[1]) return;
    if (along_drawn_edge(0, first_face) || along_drawn_edge(1, second_face)) return;
    cuts_.pieces.push_back({found_[0], found_[1]});
  }

  SurfaceCuts take() { return std::move(cuts_); }

 private:
  static bool on_one_side(const std::array<double, 3>& distances) {
    return (distances[0] >= 0.0) == (distances[1] >= 0.0) && (distances[1] >= 0.0) == (distances[2] >= 0.0);
  }

  /// Whether what was found runs along an edge of the face that is drawn anyway.
  bool along_drawn_edge(size_t mesh, uint32_t face) const {
    const PlacedMesh& own = meshes_[mesh];
    for (const uint32_t edge : own.topology->face_edges[face]) {
      if ((*own.drawn_edges)[edge] == 0) continue;
      const auto& ends = own.topology->edges[edge].points;
      const glm::dvec3& a = own.point(ends[0]);
      const glm::dvec3 way = own.point(ends[1]) - a;
      const double length = glm::length(way);
      const auto is_near = [&](uint32_t piercing) {
        return glm::length(glm::cross(way, cuts_.piercings[piercing].at - a)) <= on_plane_ * length;
      };
      if (is_near(found_[0]) && is_near(found_[1])) return true;
    }
    return false;
  }

  /// Of a face's corners from the other mesh's face's plane.
  std::array<double, 3> distances(size_t mesh, uint32_t face, uint32_t other_face) const {
    const PlacedMesh& other = meshes_[1 - mesh];
    const Face& plane = other.topology->faces[other_face];
    const glm::dvec3& a = other.point(plane[0]);
    const glm::dvec3 normal = glm::cross(other.point(plane[1]) - a, other.point(plane[2]) - a);
    const double length = glm::length(normal);
    std::array<double, 3> result{};
    if (!(length > 0.0)) return result;
    for (size_t i = 0; i < 3; ++i) {
      const glm::dvec3& point = meshes_[mesh].point(meshes_[mesh].topology->faces[face][i]);
      result[i] = glm::dot(normal, point - a) / length;
    }
    return result;
  }

  void pierce(size_t mesh, uint32_t face, const std::array<double, 3>& distances, uint32_t other_face) {
    const PlacedMesh& own = meshes_[mesh];
    const PlacedMesh& other = meshes_[1 - mesh];
    const Face& corners = other.topology->faces[other_face];
    for (size_t i = 0; i < 3; ++i) {
      if ((distances[i] >= 0.0) == (distances[(i + 1) % 3] >= 0.0)) continue;
      const uint32_t edge = own.topology->face_edges[face][i];
      const auto& ends = own.topology->edges[edge].points;
      const bool forward = own.topology->faces[face][i] == ends[0];
      const double at_p = distances[forward ? i : (i + 1) % 3];
      const double at_q = distances[forward ? (i + 1) % 3 : i];
      const glm::dvec3& p = own.point(ends[0]);
      const glm::dvec3& q = own.point(ends[1]);
      const bool left = passes_left(p, q, other, corners[0], corners[1]);
      if (left != passes_left(p, q, other, corners[1], corners[2]) ||
          left != passes_left(p, q, other, corners[2], corners[0]))
        continue;
      const double along = at_p / (at_p - at_q);
      found_.push_back(
          number({is_one_ ? 0 : static_cast<int>(mesh), edge, other_face, along, p + along * (q - p)}));
    }
  }

  uint32_t number(const Piercing& piercing) {
    const auto [place, is_new] =
        numbers_.try_emplace({piercing.mesh, piercing.edge, piercing.face}, cuts_.piercings.size());
    if (is_new) cuts_.piercings.push_back(piercing);
    return place->second;
  }

  std::array<PlacedMesh, 2> meshes_;
  bool is_one_;
  double on_plane_;
  std::map<std::tuple<int, uint32_t, uint32_t>, uint32_t> numbers_;
  std::vector<uint32_t> found_;
  SurfaceCuts cuts_;
};

Box box_of(const PlacedMesh& mesh, uint32_t face) {
  Box box;
  for (const uint32_t point : mesh.topology->faces[face]) {
    // Rounded outwards, since points of another mesh's space are no floats.
    const glm::dvec3& at = mesh.point(point);
    for (int axis = 0; axis < 3; ++axis) {
      const auto near = static_cast<float>(at[axis]);
      box.low[axis] = std::min(box.low[axis], std::nextafterf(near, -INFINITY));
      box.high[axis] = std::max(box.high[axis], std::nextafterf(near, INFINITY));
    }
  }
  return box;
}

bool share_point(const Face& a, const Face& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](uint32_t point) { return std::find(b.begin(), b.end(), point) != b.end(); });
}

}  // namespace

SurfaceCuts cut_surfaces(const CutMesh& first, const CutMesh& second, const glm::dmat4& second_to_first) {
  const MeshTopology& topology = second.tree->topology();
  const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(second_to_first))));
  const double on_plane = std::max(first.tree->on_plane(), second.tree->on_plane() * scale);
  const glm::dvec3 aside = 0.1 * on_plane * glm::dvec3(0.4126, 0.5873, 0.6963);
  std::vector<glm::dvec3> moved;
  moved.reserve(topology.positions.size());
  for (const glm::dvec3& point : topology.positions)
    moved.push_back(glm::dvec3(second_to_first * glm::dvec4(point, 1.0)) + aside);
  const PlacedMesh of_first{&first.tree->topology(), first.drawn_edges, &first.tree->topology().positions};
  const PlacedMesh of_second{&topology, second.drawn_edges, &moved};
  Cutter cutter(of_first, of_second, on_plane);
  const BoxTree& boxes = first.tree->boxes();
  for (uint32_t face = 0; face < topology.faces.size(); ++face) {
    const Box box = box_of(of_second, face);
    boxes.walk([&](uint32_t node) { return boxes.nodes()[node].box.touches(box); },
               [&](uint32_t other) { cutter.cut(other, face); });
  }
  return cutter.take();
}

SurfaceCuts cut_with_itself(const CutMesh& mesh) {
  const MeshTopology& topology = mesh.tree->topology();
  const PlacedMesh same{&topology, mesh.drawn_edges, &topology.positions};
  Cutter cutter(same, same, mesh.tree->on_plane());
  const BoxTree& boxes = mesh.tree->boxes();
  for (uint32_t face = 0; face < topology.faces.size(); ++face) {
    const Box box = box_of(same, face);
    boxes.walk([&](uint32_t node) { return boxes.nodes()[node].box.touches(box); },
               [&](uint32_t other) {
                 if (other < face && !share_point(topology.faces[other], topology.faces[face]))
                   cutter.cut(other, face);
               });
  }
  return cutter.take();
}

}  // namespace inkbench
