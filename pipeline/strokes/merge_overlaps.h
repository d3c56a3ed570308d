// SPDX-License-Identifier: MIT
// One outline where a mesh gives many: the visible pieces of a silhouette of triangles run over each other's
// ends, since it turns back on itself at every second edge (Northrup and Markosian 2000, Isenberg et al.
// 2002). In: paths. Out: fewer, each as long as the outline goes on.
#pragma once

#include <vector>

#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// Of outlines (silhouettes, boundaries, and against other objects) of one object, hidden or not: two become
/// one where each ends within 2 px of the other and both go the same way there, by 45 degrees at most; over
/// the part that both have (20 px at most) the path goes over from the first to the second. Short pieces (of
/// up to 12 px) along a longer path are left out.
std::vector<StrokePath> merge_overlaps(const std::vector<StrokePath>& paths);

}  // namespace inkbench
