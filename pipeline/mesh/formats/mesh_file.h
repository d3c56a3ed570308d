// SPDX-License-Identifier: MIT
// Mesh files to meshes: OBJ, PLY, OFF and STL through readers of our own, other programs' files through
// scene_import. In: a path. Out: a polygon soup, or a drawable mesh with notes on every defect.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/mesh/mesh_from_soup.h"

namespace inkbench {

/// What the file holds, or the part of it of that name or number (see `find_part`), by the format that its
/// name's ending says. Errors (input): missing, empty, not a regular file, truncated, not of that format,
/// unknown format, no such part, each with the file's name (and line), what was found and what would be
/// right.
PolygonSoup read_mesh_soup(const std::filesystem::path& path, const std::string& part = "");

/// Reads a mesh and keeps all that can be drawn, as `mesh_from_soup` says. Errors (input): as
/// `read_mesh_soup`; no face left.
Mesh load_mesh_file(const std::filesystem::path& path, const MeshOptions& options = {},
                    const std::string& part = "");

/// The endings of the names of mesh files, in lower case: ".obj", ".ply", ...
std::vector<std::string_view> mesh_endings();

/// ".obj, .ply, ...": all of them, for messages.
std::string known_mesh_formats();

/// Does the name end as one of a mesh file does?
bool is_mesh_name(const std::filesystem::path& path);

/// Errors (input): missing, empty, not a regular file, larger than any reader takes.
void check_mesh_file(const std::filesystem::path& path);

/// Where the rabbit lies: $INKBENCH_RABBIT, else bunny.obj of Debian's package glmark2-data.
/// Errors (input): which package to install and which variable to set.
std::filesystem::path find_rabbit();

}  // namespace inkbench
