// SPDX-License-Identifier: MIT
// A mesh file checked and reduced to its plain form before OpenMesh sees it: only points, normals and faces,
// every number readable, as many as announced. In: a file's raw bytes. Out: bytes for OpenMesh. This is
// where junk and truncation are found, because OpenMesh's readers loop, crash or go on with stale values when
// they meet them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace inkbench {

enum class MeshFormat { obj, ply, off, stl };

struct MeshSource {
  MeshFormat format = MeshFormat::obj;  ///< Of `bytes`, which need not be the file's.
  bool binary = false;
  std::string bytes;
  uint64_t vertices = 0;  ///< Points in `bytes` (STL: three for each face, before equal ones are merged).
  uint64_t faces = 0;     ///< Faces in `bytes`.
  uint64_t skipped_faces = 0;  ///< Faces left out here: fewer than three corners.
};

/// Stands in `MeshSource::bytes` where the file has NaN, infinity or a number too large for a float, which
/// OpenMesh's text readers would stumble over.
inline constexpr float kNotFinite = 3.4028235e38F;

/// The plain form of a file called `name`, by the format its name promises. Errors (input): not of that
/// format, truncated, unreadable; with the line where there is one.
MeshSource prepare_mesh(MeshFormat format, const std::string& name, std::string_view raw);

/// One format each. `prepare_stl` tells the binary from the ASCII kind.
MeshSource prepare_obj(const std::string& name, std::string_view raw);
MeshSource prepare_ply(const std::string& name, std::string_view raw);
MeshSource prepare_off(const std::string& name, std::string_view raw);
MeshSource prepare_stl(const std::string& name, std::string_view raw);

}  // namespace inkbench
