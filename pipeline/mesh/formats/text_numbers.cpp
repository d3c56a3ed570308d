// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

std::string count_text(uint64_t count) {
  return with_commas(static_cast<long long>(std::min<uint64_t>(count, std::numeric_limits<int64_t>::max())));
}

bool is_not_finite_word(std::string_view token) {
  if (!token.empty() && (token[0] == '+' || token[0] == '-')) token.remove_prefix(1);
  return starts_with_word(token, "nan") || starts_with_word(token, "inf") || token.starts_with("1.#");
}

/// Without a plus sign, which from_chars does not take; "" where another sign follows it.
std::string_view without_plus(std::string_view token) {
  if (!token.starts_with('+')) return token;
  token.remove_prefix(1);
  return token.starts_with('-') ? std::string_view() : token;
}

double number_of(TextCursor& cursor, std::string_view token, const char* what) {
  if (const auto number = parse_number(token)) return *number;
  throw cursor.error(shown(token) + " is not a number", fmt::format("{} needs 3 numbers", what));
}

template <class NextToken>
glm::dvec3 three_numbers(TextCursor& cursor, const char* what, const NextToken& next_token) {
  glm::dvec3 numbers(0.0);
  for (int i = 0; i < 3; ++i) {
    const std::string_view token = next_token();
    if (token.empty()) {
      throw cursor.error(fmt::format("{} has {} of its 3 numbers: {}", what, i, shown(trim(cursor.line()))),
                         "the file may be truncated or damaged here");
    }
    numbers[i] = number_of(cursor, token, what);
  }
  return numbers;
}

}  // namespace

std::optional<double> parse_number(std::string_view token) {
  const std::string_view digits = without_plus(token);
  double value = 0.0;
  const auto [end, status] = std::from_chars(digits.begin(), digits.end(), value);
  const bool is_whole = !digits.empty() && end == digits.end();
  if (is_whole && status == std::errc()) return value;
  if (is_whole && status == std::errc::result_out_of_range) {
    return std::strtod(std::string(digits).c_str(), nullptr);  // infinity, or next to nothing
  }
  if (is_not_finite_word(token)) return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}

std::optional<int64_t> parse_integer(std::string_view token) {
  const std::string_view digits = without_plus(token);
  int64_t value = 0;
  const auto [end, status] = std::from_chars(digits.begin(), digits.end(), value);
  if (digits.empty() || end != digits.end() || status == std::errc::invalid_argument) return std::nullopt;
  if (status == std::errc()) return value;
  using Limits = std::numeric_limits<int64_t>;
  return digits.starts_with('-') ? Limits::min() : Limits::max();
}

std::optional<uint64_t> parse_count(std::string_view token) {
  uint64_t value = 0;
  const auto [end, status] = std::from_chars(token.begin(), token.end(), value);
  if (token.empty() || end != token.end() || status != std::errc()) return std::nullopt;
  return value;
}

int32_t to_index(int64_t value) {
  using Limits = std::numeric_limits<int32_t>;
  return static_cast<int32_t>(std::clamp<int64_t>(value, Limits::min(), Limits::max()));
}

glm::dvec3 read_three_numbers(TextCursor& cursor, const char* what) {
  return three_numbers(cursor, what, [&] { return cursor.token(); });
}

glm::dvec3 read_three_numbers_across_lines(TextCursor& cursor, const char* what) {
  return three_numbers(cursor, what, [&] { return cursor.token_across_lines(); });
}

Error truncation_error(const std::string& name, uint64_t announced_vertices, uint64_t announced_faces,
                       uint64_t found_vertices, uint64_t found_faces) {
  return input_error(name,
                     fmt::format("truncated: the header announces {} and {}, but the file holds {} and {}",
                                 counted(announced_vertices, "vertex", "vertices"),
                                 counted(announced_faces, "face", "faces"), count_text(found_vertices),
                                 count_text(found_faces)),
                     "copy or download the file again");
}

}  // namespace inkbench
