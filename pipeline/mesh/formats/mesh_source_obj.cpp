// SPDX-License-Identifier: MIT
// Wavefront OBJ: keeps `v`, `vn` and `f` lines, the latter as "point" or "point//normal".
#include <algorithm>

#include "pipeline/mesh/formats/mesh_source.h"
#include "pipeline/mesh/formats/mesh_text.h"

namespace inkbench {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// One corner, "point", "point/texture", "point//normal" or "point/texture/normal"; false where it is none.
bool append_corner(std::string_view corner, std::string& out) {
  const size_t first_slash = std::min(corner.find('/'), corner.size());
  if (!append_integer(corner.substr(0, first_slash), out)) return false;
  if (first_slash == corner.size()) return true;
  const size_t second_slash = corner.find('/', first_slash + 1);
  if (second_slash == std::string_view::npos || second_slash + 1 == corner.size()) return true;
  out.back() = '/';
  out.push_back('/');
  return append_integer(corner.substr(second_slash + 1), out);
}

bool is_last_content(const TextCursor& cursor) {
  return cursor.rest().find_first_not_of(" \t\r\n") == std::string_view::npos;
}

class ObjPreparation {
 public:
  ObjPreparation(const std::string& name, std::string_view raw) : cursor_(name, raw) {
    source_.format = MeshFormat::obj;
    source_.bytes.reserve(raw.size());
  }

  MeshSource run() {
    while (cursor_.next_line()) take_line();
    return std::move(source_);
  }

 private:
  void take_line() {
    const std::string_view keyword = cursor_.token();
    if (keyword == "v") {
      source_.bytes += "v ";
      append_three_numbers(cursor_, "a vertex", source_.bytes);
      ++source_.vertices;
    } else if (keyword == "vn") {
      source_.bytes += "vn ";
      append_three_numbers(cursor_, "a normal", source_.bytes);
    } else if (keyword == "f") {
      take_face();
    }
  }

  void take_face() {
    const size_t before = source_.bytes.size();
    source_.bytes += "f ";
    const size_t corners = append_corners();
    source_.bytes.push_back('\n');
    if (corners >= 3) {
      ++source_.faces;
      return;
    }
    if (is_last_content(cursor_)) {
      throw cursor_.error("truncated: the last face has " + std::to_string(corners) + " corners",
                          "a face needs 3 or more; copy or download the file again");
    }
    source_.bytes.resize(before);
    ++source_.skipped_faces;
  }

  size_t append_corners() {
    size_t corners = 0;
    for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token()) {
      if (token.starts_with('#')) break;
      if (token == "\\") {  // the face goes on in the next line
        if (!cursor_.next_line()) break;
        continue;
      }
      if (!append_corner(token, source_.bytes)) {
        throw cursor_.error(shown(token) + " is not a face corner",
                            "corners look like 1, 1/2, 1//3 or 1/2/3");
      }
      ++corners;
    }
    return corners;
  }

  TextCursor cursor_;
  MeshSource source_;
};

}  // namespace

MeshSource prepare_obj(const std::string& name, std::string_view raw) {
  if (raw.find('\0') != std::string_view::npos) {
    throw input_error(name, "is binary, not an OBJ file",
                      "an OBJ file is text with lines 'v x y z' and 'f 1 2 3'");
  }
  if (raw.starts_with(kByteOrderMark)) raw.remove_prefix(kByteOrderMark.size());
  MeshSource source = ObjPreparation(name, raw).run();
  if (source.vertices == 0) {
    throw input_error(name, "has no vertices: not an OBJ file?",
                      "an OBJ file is text with lines 'v x y z' and 'f 1 2 3'");
  }
  return source;
}

}  // namespace inkbench
