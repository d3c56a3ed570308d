// SPDX-License-Identifier: MIT
#include "pipeline/lines/mesh_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace inkbench {
namespace {

using Uses = std::span<const MeshTopology::Use>;

/// `facing(face)` as `face_facing`.
template <class Facing>
bool is_silhouette(Uses uses, const Facing& facing) {
  int fronts = 0;
  int backs = 0;
  int balance = 0;
  for (const MeshTopology::Use& use : uses) {
    const int8_t towards = facing(use.face);
    fronts += towards > 0 ? 1 : 0;
    backs += towards < 0 ? 1 : 0;
    if (towards > 0) balance += use.forward ? 1 : -1;
  }
  return fronts > 0 && backs > 0 && (uses.size() == 2 || balance != 0);
}

bool is_crease(Uses uses, const std::vector<glm::dvec3>& normals, double min_cosine) {
  const auto within = [&](const MeshTopology::Use& a, const MeshTopology::Use& b) {
    return glm::dot(normals[a.face], normals[b.face]) >= min_cosine;
  };
  const bool all_known = std::all_of(uses.begin(), uses.end(), [&](const MeshTopology::Use& use) {
    return normals[use.face] != glm::dvec3(0.0);
  });
  if (uses.size() < 2 || !all_known) return false;
  if (uses.size() == 2) return !within(uses[0], uses[1]);
  return std::any_of(uses.begin(), uses.end(), [&](const MeshTopology::Use& use) {
    return std::none_of(uses.begin(), uses.end(), [&](const MeshTopology::Use& other) {
      return consistent(use, other) && within(use, other);
    });
  });
}

template <class Test>
std::vector<uint32_t> edges_that(const MeshTopology& topology, const Test& test) {
  std::vector<uint32_t> result;
  for (uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (test(topology.uses_of(topology.edges[e]))) result.push_back(e);
  }
  return result;
}

}  // namespace

int8_t face_facing(const MeshTopology& topology, uint32_t face, const Viewpoint& eye, bool mirrored) {
  const glm::dvec3& normal = topology.normals[face];
  if (normal == glm::dvec3(0.0)) return 0;
  const double towards = glm::dot(normal, eye.from(topology.positions[topology.faces[face][0]]));
  return (mirrored ? towards < 0.0 : towards > 0.0) ? 1 : -1;
}

std::vector<int8_t> face_facings(const MeshTopology& topology, const Viewpoint& eye, bool mirrored) {
  std::vector<int8_t> facings(topology.faces.size());
  for (uint32_t f = 0; f < facings.size(); ++f) facings[f] = face_facing(topology, f, eye, mirrored);
  return facings;
}

std::vector<uint32_t> silhouette_edges(const MeshTopology& topology, const std::vector<int8_t>& facings) {
  return edges_that(
      topology, [&](Uses uses) { return is_silhouette(uses, [&](uint32_t face) { return facings[face]; }); });
}

std::vector<uint32_t> silhouette_edges(const MeshTopology& topology, std::span<const uint32_t> candidates,
                                       const Viewpoint& eye, bool mirrored) {
  const auto facing = [&](uint32_t face) { return face_facing(topology, face, eye, mirrored); };
  std::vector<uint32_t> result;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(result),
               [&](uint32_t edge) { return is_silhouette(topology.uses_of(topology.edges[edge]), facing); });
  return result;
}

std::vector<uint32_t> boundary_edges(const MeshTopology& topology, double angle_deg) {
  std::vector<uint32_t> result = edges_that(topology, [](Uses uses) { return uses.size() == 1; });
  std::erase_if(result, [&](uint32_t edge) { return topology.cover_angles_deg[edge] <= angle_deg; });
  return result;
}

std::vector<uint32_t> crease_edges(const MeshTopology& topology, double angle_deg,
                                   const glm::dmat3& stretch) {
  const double min_cosine = std::cos(glm::radians(angle_deg));
  if (stretch == glm::dmat3(1.0)) {
    return edges_that(topology, [&](Uses uses) { return is_crease(uses, topology.normals, min_cosine); });
  }
  const glm::dmat3 to_stretched = glm::transpose(glm::inverse(stretch));
  std::vector<glm::dvec3> normals = topology.normals;
  for (glm::dvec3& normal : normals) {
    const glm::dvec3 stretched = to_stretched * normal;
    normal = normal == glm::dvec3(0.0) ? normal : glm::normalize(stretched);
  }
  return edges_that(topology, [&](Uses uses) { return is_crease(uses, normals, min_cosine); });
}

std::vector<Link> links_of(const MeshTopology& topology, const std::vector<uint32_t>& edges) {
  std::vector<Link> links;
  links.reserve(edges.size());
  for (const uint32_t edge : edges) links.push_back(topology.edges[edge].points);
  return links;
}

}  // namespace inkbench
