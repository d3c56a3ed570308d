// SPDX-License-Identifier: MIT
// One mesh of an Assimp scene at its place as a polygon soup, in the pose that the file shows.
#pragma once

#include "pipeline/mesh/formats/assimp/node_places.h"
#include "pipeline/mesh/polygon_soup.h"

namespace inkbench {

using NodePlaces = std::map<std::string, glm::dmat4>;

/// Points follow their bones where the mesh has any, else `to_world`; faces are turned over where that
/// mirrors. Lines and points are left out. `is_flat` is the format's word on meshes without normals.
PolygonSoup part_soup(const aiMesh& mesh, const glm::dmat4& to_world, const NodePlaces& places, bool is_flat);

}  // namespace inkbench
