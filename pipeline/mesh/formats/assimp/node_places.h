// SPDX-License-Identifier: MIT
// Where the nodes of an Assimp scene stand: in double precision, y up, in metres where the file says its
// unit.
#pragma once

#include <assimp/scene.h>

#include <glm/mat4x4.hpp>
#include <map>
#include <string>
#include <vector>

namespace inkbench {

struct PlacedNode {
  const aiNode* node = nullptr;
  glm::dmat4 to_world{1.0};
};

/// All nodes, each after its parent.
std::vector<PlacedNode> place_nodes(const aiScene& scene);

/// The first node of each name.
std::map<std::string, glm::dmat4> places_by_name(const std::vector<PlacedNode>& nodes);

glm::dmat4 to_matrix(const aiMatrix4x4& matrix);
glm::dvec3 to_vector(const aiVector3D& vector);

/// A direction or a normal's turn, without the place.
glm::dvec3 turned(const glm::dmat4& to_world, const aiVector3D& direction);
glm::dvec3 placed(const glm::dmat4& to_world, const aiVector3D& point);

}  // namespace inkbench
