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

/// A mesh as the cut sees it: with its points in the first mesh's space.
struct CutMesh {
  const MeshTopology* topology = nullptr;
  const std::vector<glm::dvec3>* points = nullptr;

  const glm::dvec3& point(uint32_t index) const { return (*points)[index]; }
};

/// Six times the volume of the tetrahedron from a line, p to q, and an edge, whose sign says on which side of
/// each other they pass. Worked out from the edge's smaller point on, so that faces which share it agree.
bool passes_left(const glm::dvec3& p, const glm::dvec3& q, const CutMesh& mesh, uint32_t from, uint32_t to) {
  const bool forward = from < to;
  const glm::dvec3& a = mesh.point(std::min(from, to));
  const glm::dvec3& b = mesh.point(std::max(from, to));
  const double volume = glm::dot(q - p, glm::cross(a - p, b - p));
  return forward ? volume >= 0.0 : !(volume >= 0.0);
}

class Cutter {
 public:
  Cutter(const CutMesh& first, const CutMesh& second, double on_plane)
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
    if (found_.size() != 2 || found_[0] == found_[1] || along_one_edge()) return;
    cuts_.pieces.push_back({found_[0], found_[1]});
  }

  SurfaceCuts take() { return std::move(cuts_); }

 private:
  static bool on_one_side(const std::array<double, 3>& distances) {
    return (distances[0] >= 0.0) == (distances[1] >= 0.0) && (distances[1] >= 0.0) == (distances[2] >= 0.0);
  }

  bool along_one_edge() const {
    const Piercing& a = cuts_.piercings[found_[0]];
    const Piercing& b = cuts_.piercings[found_[1]];
    return a.mesh == b.mesh && a.edge == b.edge;
  }

  /// Of a face's corners from the other mesh's face's plane.
  std::array<double, 3> distances(size_t mesh, uint32_t face, uint32_t other_face) const {
    const CutMesh& other = meshes_[1 - mesh];
    const Face& plane = other.topology->faces[other_face];
    const glm::dvec3& a = other.point(plane[0]);
    const glm::dvec3 normal = glm::cross(other.point(plane[1]) - a, other.point(plane[2]) - a);
    const double length = glm::length(normal);
    std::array<double, 3> result{};
    if (!(length > 0.0)) return result;
    for (size_t i = 0; i < 3; ++i) {
      const glm::dvec3& point = meshes_[mesh].point(meshes_[mesh].topology->faces[face][i]);
      const double distance = glm::dot(normal, point - a) / length;
      result[i] = std::abs(distance) <= on_plane_ ? 0.0 : distance;
    }
    return result;
  }

  void pierce(size_t mesh, uint32_t face, const std::array<double, 3>& distances, uint32_t other_face) {
    const CutMesh& own = meshes_[mesh];
    const CutMesh& other = meshes_[1 - mesh];
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

  std::array<CutMesh, 2> meshes_;
  bool is_one_;
  double on_plane_;
  std::map<std::tuple<int, uint32_t, uint32_t>, uint32_t> numbers_;
  std::vector<uint32_t> found_;
  SurfaceCuts cuts_;
};

Box box_of(const CutMesh& mesh, uint32_t face) {
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

SurfaceCuts cut_surfaces(const TriangleTree& first, const TriangleTree& second,
                         const glm::dmat4& second_to_first) {
  std::vector<glm::dvec3> moved;
  moved.reserve(second.topology().positions.size());
  for (const glm::dvec3& point : second.topology().positions)
    moved.emplace_back(second_to_first * glm::dvec4(point, 1.0));
  const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(second_to_first))));
  const CutMesh of_first{&first.topology(), &first.topology().positions};
  const CutMesh of_second{&second.topology(), &moved};
  Cutter cutter(of_first, of_second, std::max(first.on_plane(), second.on_plane() * scale));
  for (uint32_t face = 0; face < second.topology().faces.size(); ++face) {
    const Box box = box_of(of_second, face);
    first.boxes().walk([&](uint32_t node) { return first.boxes().nodes()[node].box.touches(box); },
                       [&](uint32_t other) { cutter.cut(other, face); });
  }
  return cutter.take();
}

SurfaceCuts cut_with_itself(const TriangleTree& mesh) {
  const MeshTopology& topology = mesh.topology();
  const CutMesh same{&topology, &topology.positions};
  Cutter cutter(same, same, mesh.on_plane());
  for (uint32_t face = 0; face < topology.faces.size(); ++face) {
    const Box box = box_of(same, face);
    mesh.boxes().walk([&](uint32_t node) { return mesh.boxes().nodes()[node].box.touches(box); },
                      [&](uint32_t other) {
                        if (other < face && !share_point(topology.faces[other], topology.faces[face]))
                          cutter.cut(other, face);
                      });
  }
  return cutter.take();
}

}  // namespace inkbench
