// SPDX-License-Identifier: MIT
// PLY, text and binary. Walks every element as the header describes it, so that the announced counts are
// compared with what is really there.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "pipeline/mesh/formats/mesh_readers.h"
#include "pipeline/mesh/formats/ply_header.h"
#include "pipeline/mesh/formats/text_numbers.h"

namespace inkbench {
namespace {

static_assert(std::endian::native == std::endian::little, "binary values are taken as they lie in memory");

// Both bodies have the same members; false at the end of the data. `least_bytes` is what a property takes at
// the least.

class PlyTextBody {
 public:
  explicit PlyTextBody(TextCursor& cursor) : cursor_(cursor) { cursor_.next_line(); }

  bool number(const PlyType&, double& value) {
    const std::string_view token = cursor_.token_across_lines();
    if (token.empty()) return false;
    const auto parsed = parse_number(token);
    if (!parsed) throw cursor_.error(shown(token) + " is not a number", "a coordinate is needed here");
    value = *parsed;
    return true;
  }

  bool integer(const PlyType&, int64_t& value) {
    const std::string_view token = cursor_.token_across_lines();
    if (token.empty()) return false;
    const auto parsed = parse_integer(token);
    if (!parsed) throw cursor_.error(shown(token) + " is not a number", "a vertex index is needed here");
    value = *parsed;
    return true;
  }

  bool length(const PlyType&, uint64_t& count) {
    const std::string_view token = cursor_.token_across_lines();
    if (token.empty()) return false;
    const auto parsed = parse_count(token);
    if (!parsed) throw cursor_.error(shown(token) + " is not a list's length");
    count = *parsed;
    return true;
  }

  bool skip(const PlyType&, uint64_t count) {
    for (; count > 0; --count) {
      if (cursor_.token_across_lines().empty()) return false;
    }
    return true;
  }

  bool can_hold(const PlyType&, uint64_t count) const { return count <= cursor_.left(); }
  size_t left() const { return cursor_.left(); }
  static size_t least_bytes(const PlyType&) { return 2; }

 private:
  TextCursor& cursor_;
};

class PlyBinaryBody {
 public:
  PlyBinaryBody(std::string_view data, bool is_swapped) : data_(data), is_swapped_(is_swapped) {}

  bool number(const PlyType& type, double& value) {
    if (!type.is_integer && type.bytes == 4) return real<uint32_t, float>(value);
    if (!type.is_integer) return real<uint64_t, double>(value);
    int64_t whole = 0;
    if (!integer(type, whole)) return false;
    value = static_cast<double>(whole);
    return true;
  }

  bool integer(const PlyType& type, int64_t& value) {
    switch (type.bytes) {
      case 1:
        return type.is_signed ? whole<uint8_t, int8_t>(value) : whole<uint8_t, uint8_t>(value);
      case 2:
        return type.is_signed ? whole<uint16_t, int16_t>(value) : whole<uint16_t, uint16_t>(value);
      default:
        return type.is_signed ? whole<uint32_t, int32_t>(value) : whole<uint32_t, uint32_t>(value);
    }
  }

  /// Lengths are not negative, so that the sign of their type does not matter.
  bool length(PlyType type, uint64_t& count) {
    type.is_signed = false;
    int64_t value = 0;
    if (!integer(type, value)) return false;
    count = static_cast<uint64_t>(value);
    return true;
  }

  bool skip(const PlyType& type, uint64_t count) {
    if (!can_hold(type, count)) return false;
    data_.remove_prefix(count * type.bytes);
    return true;
  }

  bool can_hold(const PlyType& type, uint64_t count) const { return count <= data_.size() / type.bytes; }
  size_t left() const { return data_.size(); }
  static size_t least_bytes(const PlyType& type) { return type.bytes; }

 private:
  template <class Bits>
  bool take(Bits& bits) {
    if (data_.size() < sizeof(Bits)) return false;
    std::memcpy(&bits, data_.data(), sizeof(Bits));
    data_.remove_prefix(sizeof(Bits));
    if (is_swapped_) bits = swapped(bits);
    return true;
  }

  template <class Bits>
  static Bits swapped(Bits bits) {
    auto bytes = std::bit_cast<std::array<uint8_t, sizeof(Bits)>>(bits);
    std::ranges::reverse(bytes);
    return std::bit_cast<Bits>(bytes);
  }

  template <class Bits, class Real>
  bool real(double& value) {
    Bits bits{};
    if (!take(bits)) return false;
    value = std::bit_cast<Real>(bits);
    return true;
  }

  template <class Bits, class Whole>
  bool whole(int64_t& value) {
    Bits bits{};
    if (!take(bits)) return false;
    value = int64_t{std::bit_cast<Whole>(bits)};
    return true;
  }

  std::string_view data_;
  bool is_swapped_;
};

/// One vertex, face or strip, as far as a mesh needs it.
struct PlyItem {
  std::array<double, 6> numbers{};
  std::vector<int64_t> corners;
};

template <class Body>
bool read_corners(Body& body, const PlyType& type, uint64_t count, std::vector<int64_t>& corners) {
  if (!body.can_hold(type, count)) return false;
  corners.resize(0);
  for (uint64_t i = 0; i < count; ++i) {
    int64_t corner = 0;
    if (!body.integer(type, corner)) return false;
    corners.push_back(corner);
  }
  return true;
}

template <class Body>
bool read_property(Body& body, const PlyProperty& property, PlyItem& item) {
  if (property.use == PlyUse::number) return body.number(property.type, item.numbers[property.slot]);
  uint64_t count = 1;
  if (property.is_list && !body.length(property.count_type, count)) return false;
  if (property.use == PlyUse::corners) return read_corners(body, property.type, count, item.corners);
  return body.skip(property.type, count);
}

template <class Body>
bool read_item(Body& body, const PlyElement& element, PlyItem& item) {
  for (const PlyProperty& property : element.properties) {
    if (!read_property(body, property, item)) return false;
  }
  return true;
}

class SoupBuilder {
 public:
  explicit SoupBuilder(bool has_normals) : has_normals_(has_normals) {}

  void make_room(PlyKind kind, size_t items) {
    if (kind == PlyKind::vertices) soup_.points.reserve(items);
    if (kind == PlyKind::vertices && has_normals_) soup_.normals.reserve(items);
    if (kind != PlyKind::faces) return;
    soup_.corner_counts.reserve(items);
    soup_.corners.reserve(3 * items);
  }

  void add(PlyKind kind, const PlyItem& item) {
    if (kind == PlyKind::vertices) add_vertex(item.numbers);
    if (kind == PlyKind::faces) add_face(item.corners);
    if (kind == PlyKind::strips) add_strips(item.corners);
  }

  PolygonSoup take() {
    if (has_normals_) soup_.corner_normals = soup_.corners;
    return std::move(soup_);
  }

 private:
  void add_vertex(const std::array<double, 6>& numbers) {
    soup_.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    if (has_normals_) soup_.normals.emplace_back(numbers[3], numbers[4], numbers[5]);
  }

  void add_face(const std::vector<int64_t>& corners) {
    if (corners.size() < 3) {
      ++soup_.empty_polygons;
      return;
    }
    for (const int64_t corner : corners) soup_.corners.push_back(to_index(corner));
    soup_.corner_counts.push_back(static_cast<uint32_t>(corners.size()));
  }

  /// Strips one after the other, -1 between them; every second triangle of one is turned over. A triangle
  /// that names a point twice only joins what is on its sides.
  void add_strips(const std::vector<int64_t>& corners) {
    size_t start = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] == -1) start = i + 1;
      if (corners[i] == -1 || i < start + 2) continue;
      int64_t a = corners[i - 2], b = corners[i - 1];
      const int64_t c = corners[i];
      if (a == b || b == c || a == c) continue;
      if ((i - start) % 2 == 1) std::swap(a, b);
      for (const int64_t corner : {a, b, c}) soup_.corners.push_back(to_index(corner));
      soup_.corner_counts.push_back(3);
    }
  }

  PolygonSoup soup_;
  bool has_normals_;
};

/// How many items of the element the rest of the file can hold.
template <class Body>
size_t most_items(const Body& body, const PlyElement& element) {
  size_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    bytes += body.least_bytes(property.is_list ? property.count_type : property.type);
  }
  return bytes == 0 ? 0 : std::min<uint64_t>(element.count, body.left() / bytes + 1);
}

/// Returns how many of the element's items are whole.
template <class Body>
uint64_t read_element(Body& body, const PlyElement& element, SoupBuilder& builder) {
  if (element.properties.empty()) return element.count;
  builder.make_room(element.kind, most_items(body, element));
  PlyItem item;
  for (uint64_t i = 0; i < element.count; ++i) {
    if (!read_item(body, element, item)) return i;
    builder.add(element.kind, item);
  }
  return element.count;
}

template <class Body>
PolygonSoup read_elements(Body body, const PlyHeader& header, const std::string& name) {
  SoupBuilder builder(header.has_normals);
  uint64_t vertices = 0, faces = 0;
  for (const PlyElement& element : header.elements) {
    const uint64_t found = read_element(body, element, builder);
    if (element.kind == PlyKind::vertices) vertices = found;
    if (element.kind == PlyKind::faces || element.kind == PlyKind::strips) faces += found;
    if (found < element.count) {
      throw truncation_error(name, header.count(PlyKind::vertices),
                             header.count(PlyKind::faces) + header.count(PlyKind::strips), vertices, faces);
    }
  }
  return builder.take();
}

}  // namespace

PolygonSoup read_ply(const std::string& name, std::string_view raw) {
  TextCursor cursor(name, raw);
  const PlyHeader header = read_ply_header(cursor);
  if (header.encoding == PlyEncoding::ascii) return read_elements(PlyTextBody(cursor), header, name);
  return read_elements(PlyBinaryBody(cursor.rest(), header.encoding == PlyEncoding::big_endian), header,
                       name);
}

}  // namespace inkbench
