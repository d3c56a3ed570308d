// SPDX-License-Identifier: MIT
// STL, text and binary.
#include <fmt/format.h>

#include <array>
#include <cstring>

#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/mesh_readers.h"
#include "pipeline/mesh/formats/text_numbers.h"

namespace inkbench {
namespace {

constexpr size_t kHeaderBytes = 84;
constexpr size_t kFacetBytes = 50;
constexpr size_t kCornersOffset = 12;  ///< In a facet; before it stands its normal.

uint64_t announced_facets(std::string_view raw) {
  uint32_t count = 0;
  if (raw.size() >= kHeaderBytes) std::memcpy(&count, raw.data() + kHeaderBytes - 4, 4);
  return count;
}

uint64_t held_facets(std::string_view raw) {
  return raw.size() < kHeaderBytes ? 0 : (raw.size() - kHeaderBytes) / kFacetBytes;
}

/// A writer that streams does not know the count when it writes the header, and some do not come back to it.
bool has_no_count(std::string_view raw) {
  const uint64_t announced = announced_facets(raw);
  const bool is_whole = raw.size() > kHeaderBytes && (raw.size() - kHeaderBytes) % kFacetBytes == 0;
  return is_whole && (announced == 0 || announced == UINT32_MAX);
}

void add_triangle(PolygonSoup& soup) {
  const auto first = static_cast<int32_t>(soup.points.size()) - 3;
  for (int32_t i = 0; i < 3; ++i) soup.corners.push_back(first + i);
  soup.corner_counts.push_back(3);
}

PolygonSoup read_facets(std::string_view raw, uint64_t count) {
  PolygonSoup soup;
  soup.corners_are_rounded = true;
  soup.points.reserve(3 * count);
  soup.corners.reserve(3 * count);
  soup.corner_counts.reserve(count);
  for (uint64_t facet = 0; facet < count; ++facet) {
    std::array<glm::vec3, 3> corners;
    std::memcpy(corners.data(), raw.data() + kHeaderBytes + facet * kFacetBytes + kCornersOffset,
                sizeof corners);
    for (const glm::vec3& corner : corners) soup.points.emplace_back(corner);
    add_triangle(soup);
  }
  return soup;
}

PolygonSoup read_binary(std::string_view raw) {
  const uint64_t announced = announced_facets(raw);
  const bool is_uncounted = has_no_count(raw);
  const uint64_t facets = is_uncounted ? held_facets(raw) : announced;
  PolygonSoup soup = read_facets(raw, facets);
  if (is_uncounted) {
    soup.notes.push_back(fmt::format("The header announces {}; the file's size says {}.",
                                     counted(announced, "facet", "facets"),
                                     counted(facets, "facet", "facets")));
  } else if (const size_t after = raw.size() - kHeaderBytes - facets * kFacetBytes; after > 0) {
    soup.notes.push_back(fmt::format("Left out {} after the {} that the header announces.",
                                     counted(after, "byte", "bytes"), counted(facets, "facet", "facets")));
  }
  return soup;
}

/// The keywords may stand on lines of their own or share them.
class StlTextReader {
 public:
  StlTextReader(const std::string& name, std::string_view raw) : cursor_(name, raw) {
    soup_.corners_are_rounded = true;
  }

  PolygonSoup run() {
    for (std::string_view token = cursor_.token_across_lines(); !token.empty();
         token = cursor_.token_across_lines()) {
      take(token);
    }
    end_loop();
    if (!has_ended_) {
      throw input_error(cursor_.name(),
                        fmt::format("truncated: no 'endsolid' after {}",
                                    counted(soup_.corner_counts.size(), "facet", "facets")),
                        "copy or download the file again");
    }
    return std::move(soup_);
  }

 private:
  void take(std::string_view token) {
    if (is_word(token, "vertex")) {
      soup_.points.push_back(read_three_numbers_across_lines(cursor_, "a vertex"));
      soup_.corners.push_back(static_cast<int32_t>(soup_.points.size()) - 1);
      ++loop_corners_;
    } else if (is_word(token, "outer")) {
      end_loop();
      is_in_loop_ = true;
    } else if (is_word(token, "endloop") || is_word(token, "endfacet") || is_word(token, "facet")) {
      end_loop();
    } else if (is_word(token, "solid") || is_word(token, "endsolid")) {
      end_loop();
      has_ended_ = token.size() > std::string_view("solid").size();
      pass_name();
    }
  }

  /// Any words to the end of the line, or to the first facet.
  void pass_name() {
    TextCursor ahead = cursor_;
    for (std::string_view token = ahead.token(); !token.empty(); token = ahead.token()) {
      if (is_word(token, "facet") && is_word(TextCursor(ahead).token(), "normal")) return;
      cursor_ = ahead;
    }
  }

  void end_loop() {
    if (is_in_loop_ && loop_corners_ < 3) {
      throw cursor_.error(fmt::format("a facet has {} of its 3 'vertex' lines", loop_corners_),
                          "the file may be truncated or damaged here");
    }
    if (!is_in_loop_ && loop_corners_ > 0) throw cursor_.error("'vertex' outside an 'outer loop'");
    if (is_in_loop_) soup_.corner_counts.push_back(loop_corners_);
    is_in_loop_ = false;
    loop_corners_ = 0;
  }

  TextCursor cursor_;
  PolygonSoup soup_;
  bool is_in_loop_ = false;
  uint32_t loop_corners_ = 0;
  bool has_ended_ = false;
};

bool is_stl_text(const std::string& name, std::string_view raw) {
  if (raw.find('\0') != std::string_view::npos) return false;
  return is_word(TextCursor(name, raw).token_across_lines(), "solid");
}

Error not_stl(const std::string& name) {
  return input_error(name, "is neither ASCII nor binary STL",
                     "ASCII begins with 'solid'; binary has 84 bytes and 50 for each facet");
}

}  // namespace

PolygonSoup read_stl(const std::string& name, std::string_view raw) {
  // The size first: many binary files begin with "solid" too.
  const uint64_t announced = announced_facets(raw);
  const uint64_t held = held_facets(raw);
  if (raw.size() == kHeaderBytes + kFacetBytes * announced && announced > 0) return read_binary(raw);
  if (is_stl_text(name, raw)) return StlTextReader(name, raw).run();
  const bool is_text = raw.find('\0') == std::string_view::npos;
  if (is_text || raw.size() < kHeaderBytes) throw not_stl(name);
  if (has_no_count(raw)) return read_binary(raw);
  if (announced == 0) throw input_error(name, "holds no facets", "a mesh needs triangles or polygons");
  if (held < announced) throw truncation_error(name, 3 * announced, announced, 3 * held, held);
  return read_binary(raw);
}

}  // namespace inkbench
