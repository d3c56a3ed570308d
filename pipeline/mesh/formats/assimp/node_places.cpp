// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/assimp/node_places.h"

#include <glm/ext/matrix_transform.hpp>

namespace inkbench {
namespace {

constexpr double kCentimetresInMetre = 100.0;

int setting(const aiScene& scene, const char* name, int otherwise) {
  int value = otherwise;
  return scene.mMetaData != nullptr && scene.mMetaData->Get(name, value) ? value : otherwise;
}

/// The file's axis (0 to 2) that is ours, with its sign, as FBX names them; Assimp leaves FBX files as they
/// stand and turns all others itself.
glm::dvec3 axis(const aiScene& scene, const std::string& name, int otherwise) {
  glm::dvec3 direction(0.0);
  const int index = setting(scene, name.c_str(), otherwise);
  direction[index >= 0 && index < 3 ? index : otherwise] = setting(scene, (name + "Sign").c_str(), 1);
  return direction;
}

glm::dmat4 world_of_file(const aiScene& scene) {
  float centimetres = 0.0F;  // one unit of an FBX file
  double precise = 0.0;
  if (scene.mMetaData == nullptr) return glm::dmat4(1.0);
  const bool has_unit = scene.mMetaData->Get("UnitScaleFactor", precise) ||
                        scene.mMetaData->Get("UnitScaleFactor", centimetres);
  if (!has_unit) return glm::dmat4(1.0);
  const double unit = precise > 0.0 ? precise : centimetres;
  const double scale = unit > 0.0 ? unit / kCentimetresInMetre : 1.0;
  const glm::dmat3 from_ours(axis(scene, "CoordAxis", 0), axis(scene, "UpAxis", 1),
                             axis(scene, "FrontAxis", 2));
  // Axes that are no right-handed frame are a damaged file's.
  const bool is_frame = glm::determinant(from_ours) == 1.0;
  const glm::dmat3 turn = is_frame ? glm::transpose(from_ours) : glm::dmat3(1.0);
  return glm::dmat4(turn * scale);
}

}  // namespace

glm::dmat4 to_matrix(const aiMatrix4x4& m) {
  return {
      {m.a1, m.b1, m.c1, m.d1}, {m.a2, m.b2, m.c2, m.d2}, {m.a3, m.b3, m.c3, m.d3}, {m.a4, m.b4, m.c4, m.d4}};
}

glm::dvec3 to_vector(const aiVector3D& vector) {
  return {vector.x, vector.y, vector.z};
}

glm::dvec3 turned(const glm::dmat4& to_world, const aiVector3D& direction) {
  return glm::dmat3(to_world) * to_vector(direction);
}

glm::dvec3 placed(const glm::dmat4& to_world, const aiVector3D& point) {
  return to_world * glm::dvec4(to_vector(point), 1.0);
}

std::vector<PlacedNode> place_nodes(const aiScene& scene) {
  std::vector<PlacedNode> nodes;
  if (scene.mRootNode == nullptr) return nodes;
  nodes.push_back({scene.mRootNode, world_of_file(scene) * to_matrix(scene.mRootNode->mTransformation)});
  for (size_t i = 0; i < nodes.size(); ++i) {
    const PlacedNode parent = nodes[i];
    for (unsigned child = 0; child < parent.node->mNumChildren; ++child) {
      const aiNode* const node = parent.node->mChildren[child];
      nodes.push_back({node, parent.to_world * to_matrix(node->mTransformation)});
    }
  }
  return nodes;
}

std::map<std::string, glm::dmat4> places_by_name(const std::vector<PlacedNode>& nodes) {
  std::map<std::string, glm::dmat4> places;
  for (const PlacedNode& placed_node : nodes)
    places.emplace(placed_node.node->mName.C_Str(), placed_node.to_world);
  return places;
}

}  // namespace inkbench
