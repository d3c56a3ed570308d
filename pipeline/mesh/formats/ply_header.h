// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements and properties follow, in which encoding, and what each is for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/mesh/formats/text_cursor.h"

namespace inkbench {

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyType {
  uint8_t bytes = 0;
  bool is_integer = false;
  bool is_signed = false;
};

/// What a reader of meshes does with a property. The coordinates and the components of normals are in the
/// order of `PlyProperty::slot`.
enum class PlyUse { nothing, number, corners };

struct PlyProperty {
  std::string name;
  PlyType type;
  bool is_list = false;
  PlyType count_type;  ///< Of a list's length.
  PlyUse use = PlyUse::nothing;
  int slot = 0;  ///< Of a number: 0 to 2 for x, y and z, 3 to 5 for nx, ny and nz.
};

enum class PlyKind { other, vertices, faces, strips };

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;
  PlyKind kind = PlyKind::other;
};

/// Elements up to the last that a mesh needs; what follows is of no interest.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  bool has_normals = false;  ///< One for each vertex.

  /// How many the header announces of a kind.
  uint64_t count(PlyKind kind) const;
};

/// Reads the header from the file's first line on; the cursor stands on its last line afterwards. What is
/// returned has vertices with x, y and z, and faces or triangle strips with one list of corners. Errors
/// (input): not a PLY file, malformed, without faces or vertices.
PlyHeader read_ply_header(TextCursor& cursor);

}  // namespace inkbench
