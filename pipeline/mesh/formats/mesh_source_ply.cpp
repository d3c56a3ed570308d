// SPDX-License-Identifier: MIT
// PLY, ASCII and binary. Walks every element as the header describes it, so that the announced counts are
// compared with what is really there; keeps coordinates, normals and face corners.
#include <fmt/format.h>

#include <algorithm>

#include "pipeline/mesh/formats/mesh_source.h"
#include "pipeline/mesh/formats/mesh_text.h"
#include "pipeline/mesh/formats/ply_header.h"

namespace inkbench {
namespace {

// Both bodies have the same three members: `take` passes one value, appending it to `out` where there is one;
// `take_count` a list's length; `end_item` closes a vertex or face. False at the end of the data.

class AsciiBody {
 public:
  explicit AsciiBody(TextCursor cursor) : cursor_(std::move(cursor)) {}

  bool take(const PlyType& type, std::string* out) {
    const std::string_view token = cursor_.token_across_lines();
    if (token.empty()) return false;
    if (out == nullptr) return true;
    const bool good = type.is_integer ? append_integer(token, *out) : append_number(token, *out);
    if (!good) {
      throw cursor_.error(shown(token) + " is not a number",
                          type.is_integer ? "a vertex index is needed here" : "a coordinate is needed here");
    }
    return true;
  }

  bool take_count(const PlyType&, std::string* out, uint64_t& count) {
    const std::string_view token = cursor_.token_across_lines();
    if (token.empty()) return false;
    const auto parsed = parse_count(token);
    if (!parsed) throw cursor_.error(shown(token) + " is not a list's length");
    count = *parsed;
    if (out != nullptr) *out += fmt::format("{} ", count);
    return true;
  }

  void end_item(std::string& out) { out.push_back('\n'); }

 private:
  TextCursor cursor_;
};

class BinaryBody {
 public:
  BinaryBody(std::string_view data, bool is_big_endian) : data_(data), is_big_endian_(is_big_endian) {}

  bool take(const PlyType& type, std::string* out) {
    if (data_.size() < type.bytes) return false;
    if (out != nullptr) out->append(data_.substr(0, type.bytes));
    data_.remove_prefix(type.bytes);
    return true;
  }

  bool take_count(const PlyType& type, std::string* out, uint64_t& count) {
    const std::string_view bytes = data_.substr(0, type.bytes);
    if (!take(type, out)) return false;
    count = 0;
    for (size_t i = 0; i < bytes.size(); ++i) {
      const size_t from_high = is_big_endian_ ? i : bytes.size() - 1 - i;
      count = count << 8 | static_cast<uint8_t>(bytes[from_high]);
    }
    return true;
  }

  void end_item(std::string&) {}

 private:
  std::string_view data_;
  bool is_big_endian_;
};

template <class Body>
bool take_property(Body& body, const PlyProperty& property, std::string* out) {
  if (!property.is_kept) out = nullptr;
  if (!property.is_list) return body.take(property.type, out);
  uint64_t count = 0;
  if (!body.take_count(property.count_type, out, count)) return false;
  for (uint64_t i = 0; i < count; ++i) {
    if (!body.take(property.type, out)) return false;
  }
  return true;
}

/// Passes the element's items; returns how many are whole.
template <class Body>
uint64_t take_element(Body& body, const PlyElement& element, std::string& out) {
  if (element.properties.empty()) return element.count;
  const bool is_kept = std::ranges::any_of(element.properties, &PlyProperty::is_kept);
  for (uint64_t item = 0; item < element.count; ++item) {
    for (const PlyProperty& property : element.properties) {
      if (!take_property(body, property, &out)) return item;
    }
    if (is_kept) body.end_item(out);
  }
  return element.count;
}

template <class Body>
void take_elements(Body body, const PlyHeader& header, const std::string& name, MeshSource& source) {
  for (const PlyElement& element : header.elements) {
    const uint64_t found = take_element(body, element, source.bytes);
    if (element.name == "vertex") source.vertices = found;
    if (element.name == "face") source.faces = found;
    if (found < element.count) {
      throw truncation_error(name, header.vertices().count, header.faces().count, source.vertices,
                             source.faces);
    }
  }
}

}  // namespace

MeshSource prepare_ply(const std::string& name, std::string_view raw) {
  TextCursor cursor(name, raw);
  const PlyHeader header = read_ply_header(cursor);
  MeshSource source;
  source.format = MeshFormat::ply;
  source.binary = header.encoding != PlyEncoding::ascii;
  source.bytes.reserve(raw.size());
  source.bytes = plain_ply_header(header);
  if (source.binary) {
    take_elements(BinaryBody(cursor.rest(), header.encoding == PlyEncoding::big_endian), header, name,
                  source);
  } else {
    take_elements(AsciiBody(cursor), header, name, source);
  }
  return source;
}

}  // namespace inkbench
