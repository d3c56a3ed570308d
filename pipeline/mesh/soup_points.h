// SPDX-License-Identifier: MIT
// A soup's points brought to floats and put together. In: points in double, as far from the origin and as
// small or large as a file may have them. Out: float points around the origin, and which of them are one.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "pipeline/mesh/polygon_soup.h"

namespace inkbench {

struct SoupPoints {
  glm::dvec3 origin{0.0};
  double unit = 1.0;              ///< A point of the file is origin + unit * place.
  std::vector<glm::vec3> places;  ///< For each point of the soup; of those that no face uses, anything.
  std::vector<uint32_t> first;    ///< For each the first at its place.
  size_t merged_by_rounding = 0;  ///< Put together though not equal.
};

/// `used`: for each point whether a face has it; those are finite. The origin moves to the middle of the used
/// points where they are farther from it than 16 times their extent, as georeferenced ones are: floats would
/// be too coarse there. The unit changes to a power of two where the extent is not between 1e-6 and 1e6.
/// Points at one place are one; where the format rounds each corner anew (`corners_are_rounded`) so are those
/// within a millionth of the diagonal, or 4 steps of a float at the largest coordinate where that is more.
SoupPoints take_points(const PolygonSoup& soup, const std::vector<bool>& used);

}  // namespace inkbench
