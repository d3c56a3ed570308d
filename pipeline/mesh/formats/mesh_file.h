// SPDX-License-Identifier: MIT
// Mesh files to meshes: OBJ, PLY, OFF and STL through OpenMesh's readers. In: a path. Out: a drawable mesh
// with unit normals and notes on every defect. The way: raw bytes -> plain form (mesh_source) -> OpenMesh in
// a child process (mesh_reader, isolated_call) -> polygon soup -> mesh.
#pragma once

#include <filesystem>

#include "pipeline/mesh/mesh_from_soup.h"

namespace inkbench {

/// Reads a mesh and keeps all that can be drawn, as `mesh_from_soup` says. Errors (input): missing, empty,
/// truncated, not of the format its name says, unknown format, or no face left, each with the file's name
/// (and line), what was found and what would be right.
Mesh load_mesh_file(const std::filesystem::path& path, const MeshOptions& options = {});

/// Where the rabbit lies: $INKBENCH_RABBIT, else bunny.obj of Debian's package glmark2-data.
/// Errors (input): which package to install and which variable to set.
std::filesystem::path find_rabbit();

}  // namespace inkbench
