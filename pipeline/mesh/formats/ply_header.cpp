// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "pipeline/mesh/formats/text_numbers.h"

namespace inkbench {
namespace {

struct TypeName {
  std::string_view spelling;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypes{{{"char", {1, true, true}},
                                           {"int8", {1, true, true}},
                                           {"uchar", {1, true, false}},
                                           {"uint8", {1, true, false}},
                                           {"short", {2, true, true}},
                                           {"int16", {2, true, true}},
                                           {"ushort", {2, true, false}},
                                           {"uint16", {2, true, false}},
                                           {"int", {4, true, true}},
                                           {"int32", {4, true, true}},
                                           {"uint", {4, true, false}},
                                           {"uint32", {4, true, false}},
                                           {"float", {4, false, true}},
                                           {"float32", {4, false, true}},
                                           {"double", {8, false, true}},
                                           {"float64", {8, false, true}}}};

constexpr std::array<std::string_view, 3> kCoordinates{"x", "y", "z"};
constexpr std::array<std::string_view, 3> kNormal{"nx", "ny", "nz"};
constexpr const char* kCornerList = "'property list uchar int vertex_indices', once";

PlyKind kind_of_element(std::string_view name) {
  if (name == "vertex") return PlyKind::vertices;
  if (name == "face") return PlyKind::faces;
  return name == "tristrips" ? PlyKind::strips : PlyKind::other;
}

class HeaderReader {
 public:
  explicit HeaderReader(TextCursor& cursor) : cursor_(cursor) {}

  PlyHeader read() {
    const std::string_view magic = cursor_.token();
    if (magic != "ply" && magic != "PLY") {
      throw input_error(cursor_.name(), "does not begin with 'ply': not a PLY file",
                        "the first line must be ply");
    }
    bool is_open = true;
    while (is_open) {
      if (!cursor_.next_line()) throw cursor_.error("truncated: the PLY header has no 'end_header'");
      is_open = take_line();
    }
    if (!has_format_) {
      throw input_error(cursor_.name(), "the PLY header has no format line", "'format ascii 1.0' or binary");
    }
    check_kinds();
    for (PlyElement& element : header_.elements) find_uses(element);
    forget_what_is_not_needed();
    return std::move(header_);
  }

 private:
  /// False at the header's end.
  bool take_line() {
    const std::string_view keyword = cursor_.token();
    if (keyword == "end_header") return false;
    if (keyword == "format") {
      read_format();
    } else if (keyword == "element") {
      read_element();
    } else if (keyword == "property") {
      read_property();
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info" &&
               !header_.elements.empty()) {
      // Before the first element it is a comment without the word for one, as old versions of Blender wrote.
      throw cursor_.error(shown(keyword) + " has no place in a PLY header",
                          "format, comment, element, property or end_header");
    }
    return true;
  }

  void read_format() {
    const std::string_view encoding = cursor_.token();
    has_format_ = true;
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
    header_.elements.push_back({name, *count, {}, kind_of_element(name)});
  }

  static PlyType find_type(const TextCursor& cursor, std::string_view token) {
    const auto found = std::ranges::find(kTypes, token, &TypeName::spelling);
    if (found == kTypes.end()) throw cursor.error("unknown PLY type " + shown(token));
    return found->type;
  }

  void read_property() {
    if (header_.elements.empty()) throw cursor_.error("a property without an element before it");
    PlyProperty property;
    std::string_view type = cursor_.token();
    property.is_list = type == "list";
    if (property.is_list) {
      property.count_type = find_type(cursor_, cursor_.token());
      if (!property.count_type.is_integer) throw cursor_.error("a list's length must have an integer type");
      type = cursor_.token();
    }
    property.type = find_type(cursor_, type);
    property.name = cursor_.token();
    if (property.name.empty()) throw cursor_.error("a property without a name");
    header_.elements.back().properties.push_back(property);
  }

  bool has(PlyKind kind) const {
    return std::ranges::find(header_.elements, kind, &PlyElement::kind) != header_.elements.end();
  }

  void check_kinds() const {
    if (std::ranges::find(header_.elements, "range_grid", &PlyElement::name) != header_.elements.end()) {
      throw input_error(cursor_.name(), "holds a range scan ('range_grid'), not a mesh",
                        "make a mesh of the scan first");
    }
    if (!has(PlyKind::vertices)) {
      throw input_error(cursor_.name(), "the PLY header announces no vertices", "a mesh needs them");
    }
    if (!has(PlyKind::faces) && !has(PlyKind::strips)) {
      throw input_error(cursor_.name(), "the PLY header announces no faces: a point cloud?",
                        "a mesh needs elements 'face' or 'tristrips'");
    }
  }

  void find_uses(PlyElement& element) {
    if (element.kind == PlyKind::vertices) return find_coordinates(element);
    if (element.kind != PlyKind::other) find_corners(element);
  }

  /// Marks the named properties if the element has each of them just once, as a single number.
  static bool use_numbers(PlyElement& element, std::span<const std::string_view> names, int first_slot) {
    std::vector<PlyProperty*> found;
    for (const std::string_view name : names) {
      for (PlyProperty& property : element.properties) {
        if (property.name == name && !property.is_list) found.push_back(&property);
      }
    }
    const bool is_whole =
        found.size() == names.size() && std::ranges::equal(found, names, {}, &PlyProperty::name);
    if (!is_whole) return false;
    for (size_t i = 0; i < found.size(); ++i) {
      found[i]->use = PlyUse::number;
      found[i]->slot = first_slot + static_cast<int>(i);
    }
    return true;
  }

  void find_coordinates(PlyElement& vertices) {
    if (!use_numbers(vertices, kCoordinates, 0)) {
      throw input_error(cursor_.name(), "the PLY vertices lack one of x, y and z",
                        "each must be there once, as a number");
    }
    header_.has_normals = use_numbers(vertices, kNormal, 3);
  }

  void find_corners(PlyElement& element) const {
    uint64_t lists = 0;
    for (PlyProperty& property : element.properties) {
      if (property.name != "vertex_index" && property.name != "vertex_indices") continue;
      if (!property.is_list || !property.type.is_integer) {
        throw input_error(cursor_.name(),
                          fmt::format("the PLY property '{}' is no list of whole numbers", property.name),
                          kCornerList);
      }
      property.use = PlyUse::corners;
      ++lists;
    }
    if (lists == 1) return;
    throw input_error(cursor_.name(),
                      fmt::format("the PLY elements '{}' have {} vertex indices", element.name,
                                  lists == 0 ? "no list of" : "two lists of"),
                      kCornerList);
  }

  void forget_what_is_not_needed() {
    while (header_.elements.back().kind == PlyKind::other) header_.elements.pop_back();
  }

  TextCursor& cursor_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

uint64_t PlyHeader::count(PlyKind kind) const {
  uint64_t sum = 0;
  for (const PlyElement& element : elements) sum += element.kind == kind ? element.count : 0;
  return sum;
}

PlyHeader read_ply_header(TextCursor& cursor) {
  return HeaderReader(cursor).read();
}

}  // namespace inkbench
