// SPDX-License-Identifier: MIT
// Smoother meshes than the original: Loop's subdivision by OpenMesh. In: a mesh. Out: one of four times the
// faces for each round.
#pragma once

#include <cstddef>

#include "pipeline/mesh/mesh.h"
#include "pipeline/settings/mesh_params.h"

namespace inkbench {

/// `rounds` (0 to 4) of Loop's scheme; 0 gives the mesh itself. Equal positions become one vertex first, so
/// that double vertices do not open cracks: a box rounds off. Boundaries follow the cubic B-spline of their
/// own points; non-manifold places are cut (`cut_to_manifold`) and their sides smoothed apart. Normals are
/// angle-weighted. Errors (input): rounds out of range, more than `kMaxSubdividedFaces` faces; (work): more
/// than memory holds.
Mesh subdivide_mesh(const Mesh& mesh, int rounds);

}  // namespace inkbench
