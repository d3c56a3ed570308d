// SPDX-License-Identifier: MIT
// Meshes to files, with positions and normals. What is written reads back equal through `load_mesh_file`.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

enum class MeshFileFormat { ply, obj };

/// PLY: binary, little endian, floats. `comment` (one line, may be empty) goes into the header.
std::string ply_text(const Mesh& mesh, const std::string& comment);

/// OBJ: each number in the shortest form that reads back the same.
std::string obj_text(const Mesh& mesh, const std::string& comment);

/// Writes all or nothing. Errors (work): unwritable, full disk.
void write_mesh_file(const Mesh& mesh, const std::filesystem::path& path, MeshFileFormat format,
                     const std::string& comment = "");

}  // namespace inkbench
