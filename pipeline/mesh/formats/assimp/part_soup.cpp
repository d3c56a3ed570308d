// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/assimp/part_soup.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace inkbench {
namespace {

/// Takes outward normals to outward normals, also where the matrix mirrors or flattens: the transposed
/// inverse, but for its length.
glm::dmat3 normal_matrix(const glm::dmat4& matrix) {
  const glm::dmat3 m(matrix);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0.0 ? -cofactors : cofactors;
}

/// For each point the mean of its bones' matrices; empty where the mesh has none that are in the scene.
std::vector<glm::dmat4> bone_matrices(const aiMesh& mesh, const glm::dmat4& to_world,
                                      const NodePlaces& bones) {
  std::vector<glm::dmat4> matrices;
  std::vector<double> weights(mesh.mNumBones > 0 ? mesh.mNumVertices : 0, 0.0);
  matrices.resize(weights.size(), glm::dmat4(0.0));
  bool has_any = false;
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    const auto place = bones.find(bone.mName.C_Str());
    if (place == bones.end()) continue;
    const glm::dmat4 matrix = place->second * to_matrix(bone.mOffsetMatrix);
    for (unsigned i = 0; i < bone.mNumWeights; ++i) {
      const aiVertexWeight& weight = bone.mWeights[i];
      if (weight.mVertexId >= mesh.mNumVertices || !(weight.mWeight > 0.0F)) continue;
      matrices[weight.mVertexId] += matrix * static_cast<double>(weight.mWeight);
      weights[weight.mVertexId] += weight.mWeight;
      has_any = true;
    }
  }
  if (!has_any) return {};
  for (size_t i = 0; i < matrices.size(); ++i)
    matrices[i] = weights[i] > 0.0 ? matrices[i] / weights[i] : to_world;
  return matrices;
}

void add_points(const aiMesh& mesh, const glm::dmat4& to_world, const std::vector<glm::dmat4>& bones,
                PolygonSoup& soup) {
  soup.points.reserve(mesh.mNumVertices);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i)
    soup.points.push_back(placed(bones.empty() ? to_world : bones[i], mesh.mVertices[i]));
}

void add_normals(const aiMesh& mesh, const glm::dmat4& to_world, const std::vector<glm::dmat4>& bones,
                 PolygonSoup& soup) {
  if (mesh.mNormals == nullptr) return;
  soup.normals.reserve(mesh.mNumVertices);
  const glm::dmat3 one_for_all = normal_matrix(to_world);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const glm::dvec3 normal =
        (bones.empty() ? one_for_all : normal_matrix(bones[i])) * to_vector(mesh.mNormals[i]);
    const double length = glm::length(normal);
    soup.normals.emplace_back(length > 0.0 ? normal / length : normal);
  }
}

void add_faces(const aiMesh& mesh, bool is_mirrored, PolygonSoup& soup) {
  soup.corner_counts.reserve(mesh.mNumFaces);
  soup.corners.reserve(size_t{3} * mesh.mNumFaces);
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices < 3) continue;
    const size_t begin = soup.corners.size();
    for (unsigned corner = 0; corner < face.mNumIndices; ++corner)
      soup.corners.push_back(static_cast<int32_t>(std::min<unsigned>(face.mIndices[corner], INT32_MAX)));
    if (is_mirrored) std::reverse(soup.corners.begin() + static_cast<ptrdiff_t>(begin), soup.corners.end());
    soup.corner_counts.push_back(face.mNumIndices);
  }
}

}  // namespace

PolygonSoup part_soup(const aiMesh& mesh, const glm::dmat4& to_world, const NodePlaces& places,
                      bool is_flat) {
  PolygonSoup soup;
  soup.is_flat = is_flat;
  const std::vector<glm::dmat4> bones = bone_matrices(mesh, to_world, places);
  add_points(mesh, to_world, bones, soup);
  add_normals(mesh, to_world, bones, soup);
  const glm::dmat3 turn(bones.empty() ? to_world : bones.front());
  add_faces(mesh, glm::determinant(turn) < 0.0, soup);
  if (!soup.normals.empty()) soup.corner_normals = soup.corners;
  return soup;
}

}  // namespace inkbench
