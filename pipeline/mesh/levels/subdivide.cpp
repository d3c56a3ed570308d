// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/subdivide.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/memory_room.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/normals.h"
#include "pipeline/mesh/weld_manifold.h"

namespace inkbench {
namespace {

namespace om = OpenMesh;
using LoopMesh = om::TriMesh_ArrayKernelT<>;
using Vertex = om::VertexHandle;

/// Of the result, half-edges and what is drawn of it included: measured as 102 on the rabbit.
constexpr double kBytesPerFace = 110;

void check(const Mesh& mesh, int rounds) {
  if (rounds < 0 || rounds > kMaxSubdivisionRounds)
    throw input_error("mesh.subdivide", "bad value " + std::to_string(rounds), "0 to 4 rounds");
  const size_t faces = mesh.triangles.size() << (2 * rounds);
  if (faces > kMaxSubdividedFaces) {
    throw input_error("mesh.subdivide",
                      std::to_string(rounds) + " rounds make " + with_commas(static_cast<long long>(faces)) +
                          " faces of " + with_commas(static_cast<long long>(mesh.triangles.size())),
                      "at most " + with_commas(static_cast<long long>(kMaxSubdividedFaces)) +
                          "; take fewer rounds, or fewer faces first");
  }
  if (rounds > 0) {
    check_memory(kBytesPerFace * static_cast<double>(faces), "mesh.subdivide",
                 "making " + with_commas(static_cast<long long>(faces)) + " faces", "take fewer rounds");
  }
}

/// How many points of the mesh had no place among the half-edges' faces is of no interest here: a face
/// refused (not expected after the cuts) is a hole.
LoopMesh halfedges_of(const Mesh& mesh, const ManifoldPieces& pieces) {
  LoopMesh halfedges;
  halfedges.reserve(pieces.origin.size(), pieces.triangles * 3 / 2 + 1, pieces.triangles);
  for (const uint32_t vertex : pieces.origin) {
    const glm::vec3& p = mesh.positions[vertex];
    halfedges.add_vertex({p.x, p.y, p.z});
  }
  for (const auto& corners : pieces.corners) {
    if (corners[0] == ManifoldPieces::kLeftOut) continue;
    halfedges.add_face(Vertex(static_cast<int>(corners[0])), Vertex(static_cast<int>(corners[1])),
                       Vertex(static_cast<int>(corners[2])));
  }
  return halfedges;
}

size_t largest_valence(const LoopMesh& halfedges) {
  size_t largest = 0;
  for (const auto vertex : halfedges.vertices())
    largest = std::max<size_t>(largest, halfedges.valence(vertex));
  return largest;
}

Mesh mesh_of(const LoopMesh& halfedges) {
  Mesh mesh;
  mesh.positions.reserve(halfedges.n_vertices());
  for (const auto vertex : halfedges.vertices()) {
    const auto& p = halfedges.point(vertex);
    mesh.positions.emplace_back(p[0], p[1], p[2]);
  }
  mesh.triangles.reserve(halfedges.n_faces());
  for (const auto face : halfedges.faces()) {
    auto& triangle = mesh.triangles.emplace_back();
    std::ranges::transform(halfedges.fv_range(face), triangle.begin(),
                           [](Vertex vertex) { return static_cast<uint32_t>(vertex.idx()); });
  }
  return mesh;
}

}  // namespace

Mesh subdivide_mesh(const Mesh& mesh, int rounds) {
  check(mesh, rounds);
  if (rounds == 0) return mesh;
  LoopMesh halfedges = halfedges_of(mesh, cut_to_manifold(mesh));
  om::Subdivider::Uniform::LoopT<LoopMesh, float> loop;
  // Its table of weights ends at 50 edges and is read beyond that unchecked.
  loop.init_weights(std::max<size_t>(largest_valence(halfedges), 6) + 1);
  loop.attach(halfedges);
  for (int round = 0; round < rounds; ++round) {
    stop_if_asked();
    loop(1);
  }
  loop.detach();
  Mesh subdivided = mesh_of(halfedges);
  subdivided.notes = mesh.notes;
  subdivided.origin = mesh.origin;
  subdivided.unit = mesh.unit;
  smooth_normals(subdivided);
  return subdivided;
}

}  // namespace inkbench
