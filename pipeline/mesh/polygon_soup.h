// SPDX-License-Identifier: MIT
// A mesh file's raw content: points and polygons as they stand there, defects included. In: what a reader
// finds. Out: what `mesh_from_soup` makes a drawable mesh of, counting every defect. Pure data.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace inkbench {

struct PolygonSoup {
  std::vector<glm::dvec3> points;       ///< As the file has them, in its units; may hold NaN and infinity.
  std::vector<uint32_t> corner_counts;  ///< One for each polygon, any number.
  std::vector<int32_t> corners;         ///< Point indices, polygon after polygon; any value.

  std::vector<glm::vec3> normals;       ///< Any number, of any length; may hold NaN.
  std::vector<int32_t> corner_normals;  ///< Empty, or for each corner an index into `normals`; any other
                                        ///< value: the file gives it none.
  /// Empty, or for each polygon its smoothing group: edges within a group are smooth, edges between groups
  /// sharp, and so are all edges of a polygon whose group is 0.
  std::vector<uint32_t> smoothing_groups;

  bool corners_are_rounded = false;  ///< The format repeats a point in each face, each time rounded (STL).
  bool is_flat = false;              ///< Where the file has no normals, its format means flat faces (glTF).
  uint64_t empty_polygons = 0;     ///< Polygons that the reader left out: fewer than three different corners.
  std::vector<std::string> notes;  ///< What the reader has to tell, one sentence each.
};

}  // namespace inkbench
