// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";
constexpr std::string_view kNotFiniteText = "3.4028235e38 ";
constexpr size_t kShownCharacters = 32;

std::string_view without_sign(std::string_view token) {
  if (!token.empty() && (token[0] == '+' || token[0] == '-')) token.remove_prefix(1);
  return token;
}

bool is_not_finite_word(std::string_view token) {
  const std::string_view word = without_sign(token);
  return starts_with_word(word, "nan") || starts_with_word(word, "inf") || word.starts_with("1.#");
}

/// A number that from_chars found out of range is either too large or only too small to tell from zero.
bool is_too_large(std::string_view digits) {
  return std::isinf(std::strtof(std::string(digits).c_str(), nullptr));
}

}  // namespace

bool TextCursor::next_line() {
  if (rest_.empty()) return false;
  const size_t end = rest_.find('\n');
  line_ = rest_.substr(0, end);
  line_rest_ = line_;
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_number_;
  return true;
}

std::string_view TextCursor::token() {
  const size_t begin = line_rest_.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    line_rest_ = {};
    return {};
  }
  const size_t end = std::min(line_rest_.find_first_of(kBlanks, begin), line_rest_.size());
  const std::string_view token = line_rest_.substr(begin, end - begin);
  line_rest_.remove_prefix(end);
  return token;
}

std::string_view TextCursor::token_across_lines() {
  std::string_view found = token();
  while (found.empty() && next_line()) found = token();
  return found;
}

void TextCursor::cut_comment() {
  for (size_t mark = line_.find('#'); mark != std::string_view::npos; mark = line_.find('#', mark + 1)) {
    // Within a token it is none: Windows writes "-1.#IND".
    if (mark > 0 && kBlanks.find(line_[mark - 1]) == std::string_view::npos) continue;
    line_rest_.remove_suffix(std::min(line_.size() - mark, line_rest_.size()));
    line_ = line_.substr(0, mark);
    return;
  }
}

Error TextCursor::error(const std::string& what, const std::string& expected) const {
  return input_error(fmt::format("{}:{}", name_, line_number_), what, expected);
}

std::string shown(std::string_view token) {
  std::string text = "'" + std::string(token.substr(0, kShownCharacters)) + "'";
  for (char& c : text) {
    if (std::isprint(static_cast<unsigned char>(c)) == 0) c = '?';
  }
  return text;
}

bool append_number(std::string_view token, std::string& out) {
  const std::string_view digits = token.starts_with('+') ? token.substr(1) : token;
  if (digits.empty() || digits.starts_with("-+") || (token != digits && digits.starts_with('-')))
    return false;
  float value = 0.0F;
  const auto [end, status] = std::from_chars(digits.begin(), digits.end(), value);
  const bool whole = end == digits.end();
  if (whole && status == std::errc() && std::isfinite(value)) {
    out.append(digits).push_back(' ');
  } else if (is_not_finite_word(token)) {
    out.append(kNotFiniteText);
  } else if (whole && status == std::errc::result_out_of_range) {
    out.append(is_too_large(digits) ? kNotFiniteText : "0 ");
  } else {
    return false;
  }
  return true;
}

bool append_integer(std::string_view token, std::string& out) {
  const std::string_view digits = token.starts_with('+') ? token.substr(1) : token;
  int32_t value = 0;
  const auto [end, status] = std::from_chars(digits.begin(), digits.end(), value);
  if (digits.empty() || end != digits.end() || status == std::errc::invalid_argument) return false;
  if (status == std::errc::result_out_of_range) {
    // Not INT_MIN: readers that count from 1 subtract one.
    const int32_t limit = std::numeric_limits<int32_t>::max();
    value = digits.starts_with('-') ? -limit : limit;
  }
  fmt::format_to(std::back_inserter(out), "{} ", value);
  return true;
}

void append_three_numbers(TextCursor& cursor, const std::string& what, std::string& out) {
  for (int i = 0; i < 3; ++i) {
    const std::string_view token = cursor.token();
    if (token.empty()) {
      throw cursor.error(fmt::format("{} has {} of its 3 numbers: {}", what, i, shown(trim(cursor.line()))),
                         "the file may be truncated or damaged here");
    }
    if (!append_number(token, out)) {
      throw cursor.error(shown(token) + " is not a number", what + " needs 3 numbers");
    }
  }
  out.push_back('\n');
}

std::optional<uint64_t> parse_count(std::string_view token) {
  uint64_t value = 0;
  const auto [end, status] = std::from_chars(token.begin(), token.end(), value);
  if (token.empty() || end != token.end() || status != std::errc()) return std::nullopt;
  return value;
}

bool starts_with_word(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return false;
  return std::equal(word.begin(), word.end(), text.begin(), [](char expected, char found) {
    return std::tolower(static_cast<unsigned char>(found)) == expected;
  });
}

Error truncation_error(const std::string& name, uint64_t announced_vertices, uint64_t announced_faces,
                       uint64_t found_vertices, uint64_t found_faces) {
  const auto text = [](uint64_t count) {
    return with_commas(
        static_cast<long long>(std::min<uint64_t>(count, std::numeric_limits<int64_t>::max())));
  };
  return input_error(
      name,
      fmt::format("truncated: the header announces {} vertices and {} faces, but the file holds {} and {}",
                  text(announced_vertices), text(announced_faces), text(found_vertices), text(found_faces)),
      "copy or download the file again");
}

}  // namespace inkbench
