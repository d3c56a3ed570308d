// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace inkbench {
namespace {

struct TypeName {
  std::string_view spelling;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypes{{{"char", {1, true, "char"}},
                                           {"int8", {1, true, "char"}},
                                           {"uchar", {1, true, "uchar"}},
                                           {"uint8", {1, true, "uchar"}},
                                           {"short", {2, true, "short"}},
                                           {"int16", {2, true, "short"}},
                                           {"ushort", {2, true, "ushort"}},
                                           {"uint16", {2, true, "ushort"}},
                                           {"int", {4, true, "int"}},
                                           {"int32", {4, true, "int"}},
                                           {"uint", {4, true, "uint"}},
                                           {"uint32", {4, true, "uint"}},
                                           {"float", {4, false, "float"}},
                                           {"float32", {4, false, "float"}},
                                           {"double", {8, false, "double"}},
                                           {"float64", {8, false, "double"}}}};

/// OpenMesh takes list counts of three types only; lengths are not negative, so the sign does not matter.
const char* count_name(const PlyType& type) {
  if (type.bytes == 1) return "uchar";
  return type.bytes == 2 ? "uint16" : "int";
}

class HeaderReader {
 public:
  explicit HeaderReader(TextCursor& cursor) : cursor_(cursor) {}

  PlyHeader read() {
    read_format();
    while (true) {
      if (!cursor_.next_line()) throw cursor_.error("truncated: the PLY header has no 'end_header'");
      const std::string_view keyword = cursor_.token();
      if (keyword == "end_header") break;
      if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        throw cursor_.error(shown(keyword) + " has no place in a PLY header",
                            "format, comment, element, property or end_header");
      }
    }
    forget_what_follows_faces();
    check_vertices();
    check_faces();
    return std::move(header_);
  }

 private:
  void read_format() {
    const bool has_line = cursor_.next_line();
    const std::string_view magic = has_line ? cursor_.token() : std::string_view();
    if (magic != "ply" && magic != "PLY") {
      throw input_error(cursor_.name(), "does not begin with 'ply': not a PLY file",
                        "the first line must be ply");
    }
    const std::string_view keyword = cursor_.token_across_lines();
    const std::string_view encoding = cursor_.token();
    if (keyword != "format")
      throw cursor_.error("the PLY header has no format line", "'format ascii 1.0' or binary");
    if (encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
    } else if (encoding != "ascii") {
      throw cursor_.error("unknown PLY format " + shown(encoding),
                          "ascii, binary_little_endian or binary_big_endian");
    }
  }

  void read_element() {
    const std::string name(cursor_.token());
    const std::string_view count_text = cursor_.token();
    const auto count = parse_count(count_text);
    if (name.empty() || !count) throw cursor_.error(shown(count_text) + " is not a number of elements");
    for (const PlyElement& element : header_.elements) {
      if (element.name == name) throw cursor_.error("element " + shown(name) + " is announced twice");
    }
    header_.elements.push_back({name, *count, {}});
  }

  PlyType read_type() {
    const std::string_view token = cursor_.token();
    const auto found = std::ranges::find(kTypes, token, &TypeName::spelling);
    if (found == kTypes.end()) throw cursor_.error("unknown PLY type " + shown(token));
    return found->type;
  }

  void read_property() {
    if (header_.elements.empty()) throw cursor_.error("a property without an element before it");
    PlyProperty property;
    TextCursor ahead = cursor_;
    property.is_list = ahead.token() == "list";
    if (property.is_list) {
      cursor_.token();
      property.count_type = read_type();
      if (!property.count_type.is_integer) throw cursor_.error("a list's length must have an integer type");
    }
    property.type = read_type();
    property.name = cursor_.token();
    if (property.name.empty()) throw cursor_.error("a property without a name");
    header_.elements.back().properties.push_back(property);
  }

  PlyElement* find(const std::string& name) {
    const auto found = std::ranges::find(header_.elements, name, &PlyElement::name);
    return found == header_.elements.end() ? nullptr : &*found;
  }

  void forget_what_follows_faces() {
    const PlyElement* face = find("face");
    if (face == nullptr || find("vertex") == nullptr) {
      throw input_error(cursor_.name(), "the PLY header announces no vertices or no faces",
                        "a mesh needs both");
    }
    if (find("vertex") > face) {
      throw input_error(cursor_.name(), "the PLY file has its faces before its vertices",
                        "vertices must come first");
    }
    header_.elements.resize(static_cast<size_t>(face - header_.elements.data()) + 1);
  }

  /// Marks the named properties if the element has each of them just once, as a float or double.
  bool keep_numbers(PlyElement& element, std::span<const std::string_view> names) {
    std::vector<PlyProperty*> found;
    for (PlyProperty& property : element.properties) {
      const bool wanted = std::ranges::find(names, property.name) != names.end();
      if (wanted && !property.is_list && !property.type.is_integer) found.push_back(&property);
    }
    std::vector<std::string_view> distinct;
    for (const PlyProperty* property : found) {
      if (std::ranges::find(distinct, property->name) == distinct.end()) distinct.push_back(property->name);
    }
    if (found.size() != names.size() || distinct.size() != names.size()) return false;
    for (PlyProperty* property : found) property->is_kept = true;
    return true;
  }

  void check_vertices() {
    static constexpr std::array<std::string_view, 3> kCoordinates{"x", "y", "z"};
    static constexpr std::array<std::string_view, 3> kNormal{"nx", "ny", "nz"};
    PlyElement& vertex = *find("vertex");
    if (!keep_numbers(vertex, kCoordinates)) {
      throw input_error(cursor_.name(), "the PLY vertices lack one of x, y and z as float or double",
                        "each must be there once");
    }
    keep_numbers(vertex, kNormal);
  }

  void check_faces() {
    uint64_t lists = 0;
    for (PlyProperty& property : header_.elements.back().properties) {
      if (property.name != "vertex_index" && property.name != "vertex_indices") continue;
      property.is_kept = property.is_list && property.type.is_integer;
      lists += property.is_kept ? 1 : 0;
    }
    if (lists != 1) {
      throw input_error(cursor_.name(), "the PLY faces have no list of vertex indices",
                        "'property list uchar int vertex_indices', once");
    }
  }

  TextCursor& cursor_;
  PlyHeader header_;
};

}  // namespace

const PlyElement& PlyHeader::vertices() const {
  return *std::ranges::find(elements, "vertex", &PlyElement::name);
}

PlyHeader read_ply_header(TextCursor& cursor) {
  return HeaderReader(cursor).read();
}

std::string plain_ply_header(const PlyHeader& header) {
  static constexpr std::array<const char*, 3> kEncodings{"ascii", "binary_little_endian",
                                                         "binary_big_endian"};
  std::string text = fmt::format("ply\nformat {} 1.0\n", kEncodings[static_cast<size_t>(header.encoding)]);
  for (const PlyElement* element : {&header.vertices(), &header.faces()}) {
    text += fmt::format("element {} {}\n", element->name, element->count);
    for (const PlyProperty& property : element->properties) {
      if (!property.is_kept) continue;
      const std::string list =
          property.is_list ? fmt::format("list {} ", count_name(property.count_type)) : "";
      text += fmt::format("property {}{} {}\n", list, property.type.name, property.name);
    }
  }
  return text + "end_header\n";
}

}  // namespace inkbench
