// SPDX-License-Identifier: MIT
// Object File Format, the text kind, by tokens: vertices and faces may share lines or go on in the next one.
// Where each has a line of its own, what a line holds beyond what is needed (colours) is passed over.
#include <fmt/format.h>

#include <algorithm>

#include "pipeline/mesh/formats/mesh_readers.h"
#include "pipeline/mesh/formats/off_header.h"
#include "pipeline/mesh/formats/text_numbers.h"

namespace inkbench {
namespace {

/// Lines with something on them.
class ContentLines {
 public:
  explicit ContentLines(const TextCursor& cursor) : cursor_(cursor) {}

  /// How many tokens the next one has; 0 at the end of the text.
  size_t next() {
    if (cursor_.token_across_lines().empty()) return 0;
    size_t tokens = 1;
    while (!cursor_.token().empty()) ++tokens;
    return tokens;
  }

  bool are_at_least(uint64_t count) {
    for (; count > 0; --count) {
      if (cursor_.token_across_lines().empty()) return false;
      cursor_.next_line();
    }
    return true;
  }

 private:
  TextCursor cursor_;
};

bool is_line_over(TextCursor cursor) {
  return cursor.token().empty();
}

bool is_text_over(TextCursor cursor) {
  return cursor.token_across_lines().empty();
}

/// Does each vertex have a line of its own? Several on a line are told from one with more numbers than the
/// keyword promises by the lines' number, where the numbers on them do not tell.
bool have_own_lines(const TextCursor& cursor, const OffHeader& header) {
  if (!is_line_over(cursor)) return false;
  const auto all = static_cast<size_t>(header.all_numbers());
  ContentLines lines(cursor);
  const size_t first = lines.next();
  size_t tokens = first;
  bool are_alike = first % all != 0 || first == all;
  for (uint64_t i = 1; i < header.vertices && tokens > 0; ++i) {
    if (tokens < static_cast<size_t>(header.needed_numbers())) return false;
    tokens = lines.next();
    are_alike = are_alike && (tokens == first || tokens == 0);
  }
  return are_alike || (tokens > 0 && lines.are_at_least(header.faces));
}

/// Does the line hold one face, whole or with a colour of one or three numbers after it? Four could be
/// another triangle.
bool is_one_face(TextCursor& line) {
  const auto corners = parse_count(line.token_across_lines());
  uint64_t tokens = 0;
  while (!line.token().empty()) ++tokens;
  if (!corners) return false;
  if (tokens < *corners) return is_text_over(line);  // cut short
  const uint64_t more = tokens - *corners;
  return more == 0 || more == 1 || more == 3;
}

/// Does each face have a line of its own, at which its colour ends? So it is where there are as many lines,
/// and in a truncated file where each line that is left is one.
bool have_own_lines(const TextCursor& cursor, uint64_t faces) {
  if (ContentLines(cursor).are_at_least(faces)) return true;
  TextCursor line = cursor;
  while (!is_text_over(line)) {
    if (!is_one_face(line)) return false;
  }
  return true;
}

class OffReader {
 public:
  OffReader(const std::string& name, std::string_view raw)
      : cursor_(name, raw, {.has_comments = true}), header_(read_off_header(cursor_)) {}

  PolygonSoup run() {
    make_room();
    read_vertices();
    read_faces();
    if (header_.has_normals) soup_.corner_normals = soup_.corners;
    if (!is_text_over(cursor_)) {
      soup_.notes.push_back(fmt::format("Left out what follows the {} that the header announces.",
                                        counted(header_.faces, "face", "faces")));
    }
    return std::move(soup_);
  }

 private:
  void make_room() {
    soup_.points.reserve(std::min<uint64_t>(header_.vertices, cursor_.left() / 6 + 1));
    soup_.corner_counts.reserve(std::min<uint64_t>(header_.faces, cursor_.left() / 2 + 1));
  }

  void check_not_over(uint64_t faces) const {
    if (!is_text_over(cursor_)) return;
    throw truncation_error(cursor_.name(), header_.vertices, header_.faces, soup_.points.size(), faces);
  }

  void read_vertices() {
    const bool own_lines = have_own_lines(cursor_, header_);
    const int passed = own_lines ? 0 : header_.all_numbers() - header_.needed_numbers();
    for (uint64_t i = 0; i < header_.vertices; ++i) {
      check_not_over(0);
      soup_.points.push_back(read_three_numbers_across_lines(cursor_, "a vertex"));
      if (header_.has_normals)
        soup_.normals.emplace_back(read_three_numbers_across_lines(cursor_, "a normal"));
      for (int number = 0; number < passed; ++number) cursor_.token_across_lines();
      if (own_lines) cursor_.next_line();
    }
  }

  void read_faces() {
    const bool own_lines = have_own_lines(cursor_, header_.faces);
    for (uint64_t i = 0; i < header_.faces; ++i) {
      check_not_over(i);
      read_face();
      if (own_lines) cursor_.next_line();  // past its colour
    }
  }

  void read_face() {
    const std::string_view first = cursor_.token_across_lines();
    const auto corners = parse_count(first);
    if (!corners) throw cursor_.error(shown(first) + " is not a number of corners");
    for (uint64_t i = 0; i < *corners; ++i) read_corner(i, *corners);
    if (*corners >= 3) {
      soup_.corner_counts.push_back(static_cast<uint32_t>(*corners));
      return;
    }
    soup_.corners.resize(soup_.corners.size() - *corners);
    ++soup_.empty_polygons;
  }

  void read_corner(uint64_t place, uint64_t corners) {
    const std::string_view token = cursor_.token_across_lines();
    if (token.empty()) {
      throw cursor_.error(fmt::format("a face has {} of its {} corners", place, corners),
                          "the file may be truncated or damaged here");
    }
    const auto index = parse_integer(token);
    if (!index) throw cursor_.error(shown(token) + " is not a vertex index");
    soup_.corners.push_back(to_index(*index));
  }

  TextCursor cursor_;
  OffHeader header_;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup read_off(const std::string& name, std::string_view raw) {
  if (raw.find('\0') != std::string_view::npos) {
    TextCursor cursor(name, raw);
    read_off_header(cursor);
    throw input_error(name, "is an OFF file with bytes that are no text",
                      "the file may be truncated or damaged");
  }
  return OffReader(name, raw).run();
}

}  // namespace inkbench
