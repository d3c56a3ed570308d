// The vertex normals of a decimated or subdivided mesh. In: the level and the full mesh it comes from. Out:
// the level with normals of the chosen kind.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "pipeline/mesh/collapse_record.h"
#include "pipeline/mesh/level_normals_nearest.h"
#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// `smooth`: the angle-weighted mean of the adjacent faces, so that shading knows no more than the level's
/// geometry. `flat`: each face its own. `nearest`: those of the full mesh at the nearest point of its
/// surface, as baked normals are.
enum class LevelNormals : uint8_t { smooth, flat, nearest };
inline constexpr std::array<std::string_view, 3> kLevelNormalsNames{"smooth", "flat", "nearest"};

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
