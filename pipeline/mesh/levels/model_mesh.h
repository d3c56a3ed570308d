// SPDX-License-Identifier: MIT
// A model's mesh, and its place in the world. In: a model's parameters. Out: its mesh as loaded or made; the
// matrix from the mesh's space to the world's.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <string>

#include "pipeline/mesh/mesh_from_soup.h"
#include "pipeline/settings/model.h"

namespace inkbench {

/// The file that a model's `mesh` names. Errors (input): as `find_rabbit`.
std::filesystem::path mesh_path(const std::string& mesh);

/// How the model wants a file's polygons made a mesh.
MeshOptions mesh_options(const ModelParams& model);

/// The mesh that the model draws: loaded from `mesh` (see `mesh_path`) or made from the shape's
/// parameters. Errors (input): as `load_mesh_file`.
Mesh make_model_mesh(const ModelParams& model);

/// Model space to world space: scaled so that the longest side of `bounds` is `size` (0 keeps the mesh's
/// units), the anchor moved to the origin, then `scale`, `rotation` (about x, then y, then z) and `position`.
glm::mat4 model_matrix(const ModelParams& model, const Bounds& bounds);

}  // namespace inkbench
