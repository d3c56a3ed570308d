// SPDX-License-Identifier: MIT
// Object File Format, the text kind: OFF and its variants with normals (N), colours (C) and texture
// coordinates (ST). Keeps points, normals and faces; colours and comments go. The plain form is ASCII PLY,
// because OpenMesh's OFF reader overlooks normals when it reads from a stream.
#include <fmt/format.h>

#include "pipeline/mesh/formats/mesh_source.h"
#include "pipeline/mesh/formats/mesh_text.h"
#include "pipeline/mesh/formats/ply_header.h"

namespace inkbench {
namespace {

class OffPreparation {
 public:
  OffPreparation(const std::string& name, std::string_view raw) : cursor_(name, raw) {
    source_.format = MeshFormat::ply;
    source_.bytes.reserve(raw.size());
  }

  MeshSource run() {
    read_keyword();
    read_counts();
    while (source_.vertices < announced_vertices_) take_vertex();
    while (source_.faces < announced_faces_) take_face();
    return std::move(source_);
  }

 private:
  /// Moves to the next line with something on it and returns its first token.
  std::string_view content_token() {
    cursor_.cut_comment();
    std::string_view token = cursor_.token();
    while (token.empty() && cursor_.next_line()) {
      cursor_.cut_comment();
      token = cursor_.token();
    }
    return token;
  }

  /// The same, on a new line. Errors: truncated.
  std::string_view next_content_line() {
    std::string_view token;
    while (token.empty()) {
      if (!cursor_.next_line()) {
        throw truncation_error(cursor_.name(), announced_vertices_, announced_faces_, source_.vertices,
                               source_.faces);
      }
      cursor_.cut_comment();
      token = cursor_.token();
    }
    return token;
  }

  void read_keyword() {
    std::string_view keyword = content_token();
    const std::string_view whole = keyword;
    if (keyword.starts_with("ST")) keyword.remove_prefix(2);
    if (keyword.starts_with('C')) keyword.remove_prefix(1);
    has_normals_ = keyword.starts_with('N');
    if (has_normals_) keyword.remove_prefix(1);
    if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF") {
      throw cursor_.error(shown(whole) + " holds points of other than 3 dimensions",
                          "3 dimensions are needed");
    }
    if (keyword != "OFF") {
      throw input_error(cursor_.name(), "does not begin with 'OFF': not an OFF file",
                        "the first word must be OFF");
    }
  }

  void read_counts() {
    const std::string_view first = content_token();
    if (first == "BINARY")
      throw cursor_.error("binary OFF is not supported", "convert the file to PLY or text OFF");
    const auto vertices = parse_count(first);
    const auto faces = parse_count(content_token());
    if (!vertices || !faces) {
      throw cursor_.error("the counts after OFF are missing", "'vertices faces edges', three whole numbers");
    }
    announced_vertices_ = *vertices;
    announced_faces_ = *faces;
    source_.bytes += plain_ply_header(plain_header());
  }

  PlyHeader plain_header() const {
    constexpr PlyType kFloat{4, false, "float"};
    constexpr PlyType kInt{4, true, "int"};
    PlyElement vertices{"vertex", announced_vertices_, {}};
    for (const char* name : {"x", "y", "z"}) vertices.properties.push_back({name, kFloat, false, {}, true});
    for (const char* name : {"nx", "ny", "nz"})
      vertices.properties.push_back({name, kFloat, false, {}, has_normals_});
    const PlyElement faces{"face", announced_faces_, {{"vertex_indices", kInt, true, kInt, true}}};
    return {PlyEncoding::ascii, {vertices, faces}};
  }

  void take_number(std::string_view token) {
    if (token.empty())
      throw cursor_.error("a vertex has too few numbers", "the file may be truncated or damaged here");
    if (!append_number(token, source_.bytes)) {
      throw cursor_.error(shown(token) + " is not a number");
    }
  }

  void take_vertex() {
    take_number(next_content_line());
    for (int i = 1; i < (has_normals_ ? 6 : 3); ++i) take_number(cursor_.token());
    source_.bytes.push_back('\n');
    ++source_.vertices;
  }

  void take_face() {
    const std::string_view first = next_content_line();
    const auto corners = parse_count(first);
    if (!corners) {
      throw cursor_.error(shown(first) + " is not a number of corners");
    }
    source_.bytes.append(first).push_back(' ');
    for (uint64_t i = 0; i < *corners; ++i) {
      const std::string_view token = cursor_.token();
      if (token.empty()) {
        throw cursor_.error(fmt::format("a face has {} of its {} corners", i, *corners),
                            "the file may be truncated or damaged here");
      }
      if (!append_integer(token, source_.bytes)) {
        throw cursor_.error(shown(token) + " is not a vertex index");
      }
    }
    source_.bytes.push_back('\n');
    ++source_.faces;
  }

  TextCursor cursor_;
  MeshSource source_;
  bool has_normals_ = false;
  uint64_t announced_vertices_ = 0;
  uint64_t announced_faces_ = 0;
};

}  // namespace

MeshSource prepare_off(const std::string& name, std::string_view raw) {
  return OffPreparation(name, raw).run();
}

}  // namespace inkbench
