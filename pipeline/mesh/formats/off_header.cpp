// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/off_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/text_numbers.h"

namespace inkbench {
namespace {

struct OffKeyword {
  std::string text;
  bool has_texture_places = false;
  bool has_colours = false;
  bool has_normals = false;
  bool is_homogeneous = false;
  bool names_dimension = false;
  /// All in lower case, "n" may mean normals or the dimension.
  bool is_unclear = false;
};

bool eat(std::string_view& text, std::string_view lower_case_word) {
  if (!starts_with_word(text, lower_case_word)) return false;
  text.remove_prefix(lower_case_word.size());
  return true;
}

bool eat_exactly(std::string_view& text, char letter) {
  if (!text.starts_with(letter)) return false;
  text.remove_prefix(1);
  return true;
}

size_t tokens_on_line(TextCursor cursor) {
  size_t tokens = 0;
  while (!cursor.token().empty()) ++tokens;
  return tokens;
}

/// Of the next line with something on it.
size_t tokens_on_content_line(TextCursor cursor) {
  const std::string_view first = cursor.token_across_lines();
  return first.empty() ? 0 : 1 + tokens_on_line(cursor);
}

/// Reads the keyword, if there is one; false where the file begins with something else.
bool read_keyword(TextCursor& cursor, OffKeyword& keyword) {
  const std::string_view token = cursor.token_across_lines();
  std::string_view rest = token;
  const bool is_lower = std::ranges::none_of(token, [](unsigned char c) { return std::isupper(c) != 0; });
  keyword.has_texture_places = eat(rest, "st");
  keyword.has_colours = eat(rest, "c");
  keyword.has_normals = eat_exactly(rest, 'N');
  keyword.is_homogeneous = eat_exactly(rest, '4');
  keyword.names_dimension = eat_exactly(rest, 'n');
  keyword.is_unclear = keyword.names_dimension && is_lower && !keyword.is_homogeneous;
  const bool is_one = eat(rest, "off") && (rest.empty() || std::isdigit(static_cast<unsigned char>(rest[0])));
  if (!is_one) {
    keyword = {};
    cursor.put_back_from(token.data());
    return parse_count(token).has_value();
  }
  keyword.text = shown(token.substr(0, token.size() - rest.size()));
  cursor.put_back_from(rest.data());
  return true;
}

/// "noff" with a dimension has one number more before the counts, or that number on a line of its own.
void make_clear(const TextCursor& cursor, OffKeyword& keyword) {
  if (!keyword.is_unclear) return;
  const size_t tokens = tokens_on_content_line(cursor);
  keyword.names_dimension = tokens == 1 || tokens == 4;
  keyword.has_normals = !keyword.names_dimension;
}

void check_dimension(TextCursor& cursor, const OffKeyword& keyword) {
  const char* const needed = "points of 3 dimensions are needed";
  if (keyword.is_homogeneous) {
    throw cursor.error(keyword.text + " holds points of homogeneous coordinates (x y z w)", needed);
  }
  if (!keyword.names_dimension) return;
  const std::string_view token = cursor.token_across_lines();
  if (parse_count(token) == uint64_t{3}) return;
  throw cursor.error(fmt::format("{} holds points of {} dimensions", keyword.text, shown(token)), needed);
}

/// The number of edges says nothing that the faces do not; some files leave it out.
void pass_edge_count(TextCursor& cursor) {
  if (!cursor.token().empty()) return;
  if (tokens_on_content_line(cursor) == 1) cursor.token_across_lines();
}

}  // namespace

OffHeader read_off_header(TextCursor& cursor) {
  OffKeyword keyword;
  if (!read_keyword(cursor, keyword)) {
    throw input_error(cursor.name(), "does not begin with 'OFF': not an OFF file",
                      "the first word must be OFF");
  }
  TextCursor ahead = cursor;
  if (is_word(ahead.token_across_lines(), "binary")) {
    throw ahead.error("binary OFF is not supported", "convert the file to PLY or text OFF");
  }
  make_clear(cursor, keyword);
  check_dimension(cursor, keyword);
  const auto vertices = parse_count(cursor.token_across_lines());
  const auto faces = vertices ? parse_count(cursor.token_across_lines()) : std::nullopt;
  if (!faces) {
    throw cursor.error("the counts after OFF are missing", "'vertices faces edges', three whole numbers");
  }
  pass_edge_count(cursor);
  return {keyword.has_normals, keyword.has_colours, keyword.has_texture_places, *vertices, *faces};
}

}  // namespace inkbench
