// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements and properties follow, and in which encoding.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/mesh/formats/mesh_text.h"

namespace inkbench {

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyType {
  size_t bytes = 0;
  bool is_integer = false;
  const char* name = "";  ///< The spelling that OpenMesh's reader takes everywhere, list counts included.
};

struct PlyProperty {
  std::string name;
  PlyType type;
  bool is_list = false;
  PlyType count_type;    ///< Of a list's length.
  bool is_kept = false;  ///< Coordinates, whole normals, face corners.
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// Elements up to the faces; what follows them is of no interest.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;

  const PlyElement& vertices() const;
  const PlyElement& faces() const { return elements.back(); }
};

/// Reads the header from the file's first line on; the cursor stands on its last line afterwards. What is
/// returned has vertices with x, y and z, and faces after them with one list of corners. Errors (input): not
/// a PLY file, malformed, without faces or vertices.
PlyHeader read_ply_header(TextCursor& cursor);

/// The header of the file's plain form: kept properties only.
std::string plain_ply_header(const PlyHeader& header);

}  // namespace inkbench
