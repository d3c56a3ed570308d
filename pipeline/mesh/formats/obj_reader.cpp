// SPDX-License-Identifier: MIT
// Wavefront OBJ: `v`, `vn`, `f` and `s`. Other statements say nothing about surfaces of polygons.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "pipeline/mesh/formats/mesh_readers.h"
#include "pipeline/mesh/formats/text_numbers.h"

namespace inkbench {
namespace {

constexpr const char* kObjLooks = "an OBJ file is text with lines 'v x y z' and 'f 1 2 3'";

/// OBJ counts from 1, or back from the last one with negative numbers; from 0 here, and whatever names
/// nothing stays out of range.
int32_t index_from(int64_t number, size_t count) {
  return number < 0 ? to_index(std::max<int64_t>(number, INT32_MIN) + static_cast<int64_t>(count))
                    : to_index(std::min<int64_t>(number, INT64_MAX - 1) - 1);
}

class ObjReader {
 public:
  ObjReader(const std::string& name, std::string_view raw)
      : cursor_(name, raw, {.has_comments = true, .joins_lines = true}) {}

  PolygonSoup run() {
    do take_line();
    while (cursor_.next_line());
    check_content();
    note_left_out();
    return std::move(soup_);
  }

 private:
  void take_line() {
    const std::string_view keyword = cursor_.token();
    if (keyword == "v") {
      soup_.points.push_back(read_three_numbers(cursor_, "a vertex"));
    } else if (keyword == "vn") {
      soup_.normals.emplace_back(read_three_numbers(cursor_, "a normal"));
    } else if (keyword == "f" || keyword == "fo") {
      take_face();
    } else if (keyword == "s") {
      take_smoothing_group();
    } else if (keyword == "surf") {
      ++free_form_surfaces_;
    }
  }

  void take_face() {
    const size_t before = soup_.corners.size();
    for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token())
      take_corner(token);
    const size_t corners = soup_.corners.size() - before;
    if (corners < 3) return leave_out(before);
    soup_.corner_counts.push_back(static_cast<uint32_t>(corners));
    if (has_groups_) soup_.smoothing_groups.push_back(group_);
  }

  /// "point", "point/texture", "point//normal" or "point/texture/normal".
  void take_corner(std::string_view token) {
    const size_t first_slash = std::min(token.find('/'), token.size());
    const auto point = parse_integer(token.substr(0, first_slash));
    if (!point) throw bad_corner(token);
    soup_.corners.push_back(index_from(*point, soup_.points.size()));
    const size_t second_slash =
        first_slash == token.size() ? std::string_view::npos : token.find('/', first_slash + 1);
    const bool has_normal = second_slash != std::string_view::npos && second_slash + 1 < token.size();
    if (has_normal) take_corner_normal(token, token.substr(second_slash + 1));
    if (!has_normal && !soup_.corner_normals.empty()) soup_.corner_normals.push_back(-1);
  }

  void take_corner_normal(std::string_view token, std::string_view number) {
    const auto normal = parse_integer(number);
    if (!normal) throw bad_corner(token);
    soup_.corner_normals.resize(soup_.corners.size() - 1, -1);
    soup_.corner_normals.push_back(index_from(*normal, soup_.normals.size()));
  }

  Error bad_corner(std::string_view token) const {
    return cursor_.error(shown(token) + " is not a face corner", "corners look like 1, 1/2, 1//3 or 1/2/3");
  }

  /// A face from corner `begin` on that has too few of them.
  void leave_out(size_t begin) {
    const size_t corners = soup_.corners.size() - begin;
    if (cursor_.rest().find_first_not_of(" \t\r\n") == std::string_view::npos) {
      throw cursor_.error(fmt::format("truncated: the last face has {} corners", corners),
                          "a face needs 3 or more; copy or download the file again");
    }
    soup_.corners.resize(begin);
    if (soup_.corner_normals.size() > begin) soup_.corner_normals.resize(begin);
    ++soup_.empty_polygons;
  }

  void take_smoothing_group() {
    const std::string_view token = cursor_.token();
    uint32_t group = 0;
    const auto [end, status] = std::from_chars(token.begin(), token.end(), group);
    const bool is_number = !token.empty() && end == token.end() && status == std::errc();
    if (!is_number && !token.empty() && !is_word(token, "off") && !is_word(token, "null")) ++odd_groups_;
    group_ = is_number ? group : 0;
    if (!has_groups_) soup_.smoothing_groups.resize(soup_.corner_counts.size(), 0);
    has_groups_ = true;
  }

  void check_content() const {
    if (soup_.points.empty()) {
      throw input_error(cursor_.name(), "has no vertices: not an OBJ file?", kObjLooks);
    }
    if (free_form_surfaces_ > 0 && soup_.corner_counts.empty()) {
      throw input_error(cursor_.name(), "holds free-form surfaces ('surf') and no faces",
                        "convert the surfaces to polygons first");
    }
  }

  void note_left_out() {
    if (free_form_surfaces_ > 0) {
      soup_.notes.push_back(
          fmt::format("Left out {}: only polygons are drawn.",
                      counted(free_form_surfaces_, "free-form surface", "free-form surfaces")));
    }
    if (odd_groups_ > 0) {
      soup_.notes.push_back(fmt::format("Took {} for no smoothing group: neither a number nor 'off'.",
                                        counted(odd_groups_, "line 's'", "lines 's'")));
    }
  }

  TextCursor cursor_;
  PolygonSoup soup_;
  bool has_groups_ = false;
  uint32_t group_ = 0;
  uint64_t free_form_surfaces_ = 0;
  uint64_t odd_groups_ = 0;
};

}  // namespace

PolygonSoup read_obj(const std::string& name, std::string_view raw) {
  if (raw.find('\0') != std::string_view::npos) {
    throw input_error(name, "is binary, not an OBJ file", kObjLooks);
  }
  return ObjReader(name, raw).run();
}

}  // namespace inkbench
