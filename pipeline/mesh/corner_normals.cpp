// SPDX-License-Identifier: MIT
// Sums run in double: thousands of thin triangles around one point would otherwise leave a direction made of
// rounding.
#include "pipeline/mesh/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>
#include <tuple>

#include "pipeline/mesh/normals.h"
#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

/// Faces that turn by more against each other are folded back: no mean of theirs is a direction.
constexpr double kFoldedDeg = 179.0;
/// A triangle's height over its longest edge below which its normal is mostly rounding of floats.
constexpr double kSliver = 1e-5;
constexpr uint32_t kNoVertex = kNoPoint;

struct FaceNormal {
  glm::dvec3 normal{0.0};  ///< Unit length, or 0.
  bool is_sliver = false;
  uint32_t longest = 0;  ///< The corner at which the longest edge starts.
};

FaceNormal face_normal(const std::vector<glm::vec3>& points, const Triangle& t, uint32_t face) {
  const glm::dvec3 corners[3] = {points[t[0]], points[t[1]], points[t[2]]};
  const glm::dvec3 scaled = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = glm::length(scaled);
  double longest = -1.0;
  FaceNormal result;
  for (uint32_t i = 0; i < 3; ++i) {
    const double side = glm::length(corners[(i + 1) % 3] - corners[i]);
    if (side > longest) result.longest = 3 * face + i;
    longest = std::max(longest, side);
  }
  result.is_sliver = !(length > kSliver * longest * longest);
  if (length > 0.0) result.normal = scaled / length;
  return result;
}

/// Calls `join(a, b)` for each two uses of an edge that belong together: they run against each other and turn
/// least. `turn(a, b)`: the cosine between their faces.
template <class Turn, class Join>
void pair_uses(std::span<const EdgeUse> uses, const Turn& turn, const Join& join) {
  if (uses.size() == 2) {
    if (uses[0].is_rising != uses[1].is_rising) join(uses[0], uses[1]);
    return;
  }
  constexpr size_t kMostPaired = 16;  // more faces than that around one edge are no surface
  if (uses.size() < 2 || uses.size() > kMostPaired) return;
  uint32_t paired = 0;
  const auto is_free = [&](size_t i) { return (paired >> i & 1) == 0; };
  while (true) {
    double best = -2.0;
    size_t left = 0, right = 0;
    for (size_t i = 0; i < uses.size(); ++i) {
      for (size_t j = i + 1; j < uses.size(); ++j) {
        if (!is_free(i) || !is_free(j) || uses[i].is_rising == uses[j].is_rising) continue;
        const double cosine = turn(uses[i], uses[j]);
        if (cosine > best) std::tie(best, left, right) = std::tuple(cosine, i, j);
      }
    }
    if (best == -2.0) return;
    paired |= 1U << left | 1U << right;
    join(uses[left], uses[right]);
  }
}

class NormalMaker {
 public:
  NormalMaker(const std::vector<glm::vec3>& points, const std::vector<Triangle>& triangles,
              const std::vector<EdgeUse>& edges, const SmoothEdges& smooth)
      : points_(points),
        triangles_(triangles),
        edges_(edges),
        smooth_(smooth),
        least_cosine_(std::cos(glm::radians(std::min(smooth.below_deg, kFoldedDeg)))),
        fans_(triangles.size() * 3) {
    for (uint32_t face = 0; face < triangles.size(); ++face)
      faces_.push_back(face_normal(points, triangles[face], face));
  }

  std::vector<glm::vec3> run() {
    lend_to_slivers();
    join_fans();
    std::vector<glm::dvec3> sums(triangles_.size() * 3, glm::dvec3(0.0));
    for (uint32_t face = 0; face < triangles_.size(); ++face) add_face(face, sums);
    std::vector<glm::vec3> normals(sums.size());
    for (uint32_t corner = 0; corner < normals.size(); ++corner) {
      const glm::dvec3& sum = sums[fans_.root(corner)];
      const double length = glm::length(sum);
      const glm::dvec3& own = faces_[corner / 3].normal;
      // Faces back to back cancel down to rounding, which is no direction either.
      normals[corner] = length > 1e-9            ? glm::vec3(sum / length)
                        : own != glm::dvec3(0.0) ? glm::vec3(own)
                                                 : glm::vec3(0.0F, 1.0F, 0.0F);
    }
    return normals;
  }

 private:
  /// A sliver turns as the face across its longest edge does, which may be one too.
  void lend_to_slivers() {
    constexpr int kLongestWay = 8;
    for (int step = 0; step < kLongestWay; ++step) {
      bool any = false;
      for_each_edge(edges_, [&](size_t begin, size_t end) {
        if (end - begin != 2) return;
        const EdgeUse &a = edges_[begin], &b = edges_[begin + 1];
        any = lend(a, b) || lend(b, a) || any;
      });
      if (!any) return;
    }
  }

  bool lend(const EdgeUse& from, const EdgeUse& to) {
    FaceNormal& face = faces_[to.triangle()];
    const FaceNormal& other = faces_[from.triangle()];
    if (!face.is_sliver || face.longest != to.corner || other.is_sliver) return false;
    face.normal = from.is_rising != to.is_rising ? other.normal : -other.normal;
    face.is_sliver = false;
    return true;
  }

  double cosine(const EdgeUse& a, const EdgeUse& b) const {
    return glm::dot(faces_[a.triangle()].normal, faces_[b.triangle()].normal);
  }

  bool is_smooth(const EdgeUse& a, const EdgeUse& b) const {
    if (smooth_.groups.empty()) return smooth_.below_deg > 0.0 && cosine(a, b) > least_cosine_;
    const uint32_t group = smooth_.groups[a.triangle()];
    return group != 0 && group == smooth_.groups[b.triangle()];
  }

  void join_ends(const EdgeUse& a, const EdgeUse& b) {
    fans_.join(a.corner, next_corner(b.corner));
    fans_.join(next_corner(a.corner), b.corner);
  }

  void join_fans() {
    for_each_edge(edges_, [&](size_t begin, size_t end) {
      pair_uses(
          std::span(edges_).subspan(begin, end - begin),
          [&](const EdgeUse& a, const EdgeUse& b) { return cosine(a, b); },
          [&](const EdgeUse& a, const EdgeUse& b) {
            if (is_smooth(a, b)) join_ends(a, b);
          });
    });
  }

  void add_face(uint32_t face, std::vector<glm::dvec3>& sums) {
    const Triangle& t = triangles_[face];
    const auto added = weighted_normals({points_[t[0]], points_[t[1]], points_[t[2]]});
    for (uint32_t i = 0; i < 3; ++i) sums[fans_.root(3 * face + i)] += added[i];
  }

  const std::vector<glm::vec3>& points_;
  const std::vector<Triangle>& triangles_;
  const std::vector<EdgeUse>& edges_;
  const SmoothEdges& smooth_;
  double least_cosine_;
  std::vector<FaceNormal> faces_;
  Forest fans_;
};

}  // namespace

std::vector<glm::vec3> corner_normals(const std::vector<glm::vec3>& points,
                                      const std::vector<Triangle>& triangles,
                                      const std::vector<EdgeUse>& edges, const SmoothEdges& smooth) {
  return NormalMaker(points, triangles, edges, smooth).run();
}

void split_vertices(Mesh& mesh, const std::vector<glm::vec3>& normals, const std::vector<uint32_t>& ranks) {
  constexpr int kMostCompared = 64;  // so that a point of a million different normals costs no square of it
  struct Vertex {
    uint32_t point, next, rank;
  };
  std::vector<Vertex> vertices;
  std::vector<glm::vec3> vertex_normals;
  std::vector<uint32_t> heads(mesh.positions.size(), kNoVertex);
  for (size_t corner = 0; corner < normals.size(); ++corner) {
    uint32_t& place = mesh.triangles[corner / 3][corner % 3];
    const uint32_t point = place;
    uint32_t found = heads[point];
    for (int i = 0; found != kNoVertex && vertex_normals[found] != normals[corner]; ++i)
      found = i < kMostCompared ? vertices[found].next : kNoVertex;
    if (found == kNoVertex) {
      found = static_cast<uint32_t>(vertices.size());
      vertices.push_back({point, heads[point], ranks.empty() ? point : ranks[corner]});
      vertex_normals.push_back(normals[corner]);
      heads[point] = found;
    }
    place = found;
  }
  std::vector<uint32_t> order(vertices.size()), number(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return vertices[a].rank < vertices[b].rank; });
  std::vector<glm::vec3> positions;
  positions.reserve(order.size());
  mesh.normals.clear();
  for (const uint32_t vertex : order) {
    number[vertex] = static_cast<uint32_t>(positions.size());
    positions.push_back(mesh.positions[vertices[vertex].point]);
    mesh.normals.push_back(vertex_normals[vertex]);
  }
  mesh.positions = std::move(positions);
  for (Triangle& t : mesh.triangles) {
    for (uint32_t& vertex : t) vertex = number[vertex];
  }
}

void recompute_normals(Mesh& mesh, const SmoothEdges& smooth) {
  const std::vector<uint32_t> first = first_at_same_position(mesh.positions);
  for (Triangle& t : mesh.triangles) {
    for (uint32_t& vertex : t) vertex = first[vertex];
  }
  const std::vector<EdgeUse> edges = sorted_edges(mesh.triangles, mesh.positions.size());
  split_vertices(mesh, corner_normals(mesh.positions, mesh.triangles, edges, smooth));
}

}  // namespace inkbench
