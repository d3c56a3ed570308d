// SPDX-License-Identifier: MIT
// Files of other programs (glTF, FBX, Collada, 3DS and more) to soups and scenes, through Assimp in a child
// process with limits on time and memory. In: a path. Out: the parts with their places, cameras and lights;
// or one soup of all.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/mesh/formats/imported_scene.h"

namespace inkbench {

/// The endings of names that are read so, in lower case: ".gltf", ".glb", ...
std::span<const std::string_view> imported_endings();
bool is_imported(const std::filesystem::path& path);

/// What the file holds. The last file that was read is kept, until it changes, so that its parts are asked
/// for one by one. Errors (input): missing, too large, damaged, no part to draw; the reader's own words.
std::shared_ptr<const ImportedScene> import_scene(const std::filesystem::path& path);

/// All parts as one. Points of different parts stay apart. Normals, where only some parts have them, stand at
/// their corners alone.
PolygonSoup joined_soup(const ImportedScene& scene);

/// The part of that name, or of that number, from 1, where none has the name. Errors (input): no such part,
/// with the nearest name; `where` is the file's name.
const ImportedPart& find_part(const ImportedScene& scene, const std::string& part, const std::string& where);

/// The files that decide what a mesh file gives: itself, and the buffers that a glTF file names.
std::vector<std::filesystem::path> files_read_with(const std::filesystem::path& path);

}  // namespace inkbench
