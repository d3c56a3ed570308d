// SPDX-License-Identifier: MIT
// What covers silhouettes of the smooth surface: the mesh cannot say, since they run before or behind its own
// outline, so they take what the nearest mesh silhouette has (Hertzmann 1999). In: the lines of a view and
// what covers the mesh's. Out: the same for those of the smooth surface.
#pragma once

#include <span>
#include <vector>

#include "pipeline/curves/covering.h"

namespace inkbench {

/// Decides the parts of lines that follow (`ViewLine::follows`) by the line that covers, of the same model,
/// nearest in the world. A mesh's outline runs to and fro, and half of it is often hidden: where a visible
/// one lies no more than a face's height farther than the nearest, a ray decides, to which surfaces do not
/// count that are no more than three of them before the line. Those of models without silhouettes stay
/// visible.
void follow_silhouettes(std::span<ViewEdge> edges, const std::vector<ViewLine>& lines,
                        const Covering& covering);

}  // namespace inkbench
