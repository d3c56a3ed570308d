// SPDX-License-Identifier: MIT
// Lines between objects. In: the object-id image. Out: the borders between its regions, along pixel edges.
#pragma once

#include <vector>

#include "pipeline/image/image.h"
#include "pipeline/lines/lines.h"

namespace inkbench {

/// Borders between neighbouring pixels with different ids (background 0 is one), as lines from pixel corner
/// to pixel corner, not smoothed. A line goes on as long as the same two ids meet; where one pair meets at
/// all four sides of a corner, it turns so that pixels of the larger id that touch only there stay apart. Its
/// object is the one with the smaller mean depth beside it (both H x W x 1). Lines under 3 px are dropped, as
/// for all classes. The image's own border is no line.
std::vector<Polyline> object_lines(const Image& object_id, const Image& depth);

}  // namespace inkbench
