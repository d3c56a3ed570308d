// SPDX-License-Identifier: MIT
// The vertex normals of a decimated or subdivided mesh. In: the level and the full mesh it comes from. Out:
// the level with normals of the chosen kind.
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/mesh/levels/collapse_record.h"
#include "pipeline/mesh/levels/level_normals_nearest.h"
#include "pipeline/mesh/mesh.h"
#include "pipeline/settings/mesh_params.h"

namespace inkbench {

/// Replaces the level's normals; `flat` gives each face three vertices of its own. Sharp edges that are
/// double vertices stay sharp under `smooth` and `nearest`. `full` is used by `nearest` alone.
void apply_level_normals(Mesh& level, LevelNormals kind, const Mesh& full);

/// `mesh_at_level` with normals of the chosen kind, at its speed: `nearest` costs nothing, since a level's
/// vertices are the mesh's and keep their normals. As loaded, `smooth` too leaves the mesh's own normals,
/// which a file may give.
Mesh level_with_normals(const Mesh& mesh, const CollapseRecord& record, size_t asked_faces,
                        LevelNormals kind);

/// `nearest` for callers that keep the full mesh's tree from level to level.
void apply_nearest_normals(Mesh& level, const NearestNormals& full);

}  // namespace inkbench
