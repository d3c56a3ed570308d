// SPDX-License-Identifier: MIT
// A mesh file's raw content: points and polygons as they stand there, defects included. `mesh_from_soup`
// makes the drawable mesh of it and counts every defect. Pure: no files, no OpenMesh.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

struct PolygonSoup {
  std::vector<glm::vec3> points;  ///< May hold NaN and infinity.
  std::vector<glm::vec3>
      normals;  ///< Empty, or one for each point: any length, zero where the file has none.
  std::vector<uint32_t> corner_counts;  ///< One for each polygon, any number.
  std::vector<int32_t> corners;         ///< Point indices, polygon after polygon; any value.
  uint64_t empty_polygons = 0;  ///< Polygons that a reader left out: fewer than three different corners.
  uint64_t split_normals = 0;   ///< Points that the file gives several different normals (sharp edges).
  uint64_t merged_points = 0;   ///< Points that `merge_rounded_corners` took away.
};

/// For files that repeat a corner's coordinates in every face, each time rounded anew (STL): points nearer
/// than rounding can tell apart become the first of them, so that the faces meet. That is a millionth of the
/// bounding box's diagonal, or 4 steps of a float at the largest coordinate where those are more. The soup
/// has no normals.
void merge_rounded_corners(PolygonSoup& soup);

/// Triangulates, drops what cannot be drawn, removes isolated vertices, finds normals; each with a note and
/// count. Normals are the soup's where every vertex has exactly one usable, else computed. Errors (input): no
/// face, or none left; `where` is the file's name.
Mesh mesh_from_soup(const PolygonSoup& soup, const std::string& where);

}  // namespace inkbench
