// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace inkbench {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr size_t kShownCharacters = 32;

enum class Kind : uint8_t { plain, blank, line_end, backslash };

constexpr std::array<Kind, 256> kKinds = [] {
  std::array<Kind, 256> kinds{};
  for (const char blank : {' ', '\t', '\f', '\v'}) kinds[static_cast<uint8_t>(blank)] = Kind::blank;
  for (const char end : {'\n', '\r'}) kinds[static_cast<uint8_t>(end)] = Kind::line_end;
  kinds[static_cast<uint8_t>('\\')] = Kind::backslash;
  return kinds;
}();

Kind kind_of(char c) {
  return kKinds[static_cast<uint8_t>(c)];
}

}  // namespace

TextCursor::TextCursor(const std::string& name, std::string_view text, const TextRules& rules)
    : name_(&name), rules_(rules) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  begin_ = at_ = mark_ = text.data();
  end_ = begin_ + text.size();
  const char* const first_end = line_end(begin_);
  has_lone_returns_ = end_ - first_end > 1 && first_end[0] == '\r' && first_end[1] != '\n';
}

const char* TextCursor::line_end(const char* from) const {
  return std::find_if(from, end_, [](char c) { return kind_of(c) == Kind::line_end; });
}

const char* TextCursor::after_line_end(const char* line_end) const {
  if (line_end == end_) return end_;
  const bool is_pair = *line_end == '\r' && !has_lone_returns_ && line_end + 1 != end_ && line_end[1] == '\n';
  return line_end + (is_pair ? 2 : 1);
}

/// The line that a backslash joins to its own, or null where it joins none.
const char* TextCursor::joined_line(const char* backslash) const {
  if (!rules_.joins_lines) return nullptr;
  const char* after = backslash + 1;
  while (after != end_ && kind_of(*after) == Kind::blank) ++after;
  if (after != end_ && kind_of(*after) != Kind::line_end) return nullptr;
  return after_line_end(after);
}

bool TextCursor::next_line() {
  at_ = mark_ = after_line_end(line_end(at_));
  return at_ != end_;
}

std::string_view TextCursor::token() {
  for (; at_ != end_; ++at_) {
    const Kind kind = kind_of(*at_);
    if (kind == Kind::line_end) return {};
    if (kind == Kind::blank) continue;
    const char* const joined = kind == Kind::backslash ? joined_line(at_) : nullptr;
    if (joined == nullptr) break;
    at_ = joined - 1;
  }
  if (at_ == end_) return {};
  if (rules_.has_comments && *at_ == '#') {
    at_ = line_end(at_);
    return {};
  }
  mark_ = at_;
  while (++at_ != end_) {
    const Kind kind = kind_of(*at_);
    if (kind == Kind::plain || (kind == Kind::backslash && joined_line(at_) == nullptr)) continue;
    break;
  }
  return {mark_, static_cast<size_t>(at_ - mark_)};
}

std::string_view TextCursor::token_across_lines() {
  std::string_view found = token();
  while (found.empty() && at_ != end_) {
    at_ = after_line_end(at_);
    found = token();
  }
  return found;
}

std::string_view TextCursor::rest() const {
  const char* const next = after_line_end(line_end(at_));
  return {next, static_cast<size_t>(end_ - next)};
}

std::string_view TextCursor::line() const {
  const char* start = mark_;
  while (start != begin_ && kind_of(start[-1]) != Kind::line_end) --start;
  return {start, static_cast<size_t>(line_end(mark_) - start)};
}

Error TextCursor::error(const std::string& what, const std::string& expected) const {
  size_t number = 1;
  for (const char* end = line_end(begin_); end < mark_; end = line_end(after_line_end(end))) ++number;
  return input_error(fmt::format("{}:{}", *name_, number), what, expected);
}

std::string shown(std::string_view token) {
  std::string text = "'" + std::string(token.substr(0, kShownCharacters)) + "'";
  for (char& c : text) {
    if (std::isprint(static_cast<unsigned char>(c)) == 0) c = '?';
  }
  return text;
}

bool starts_with_word(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return false;
  return std::equal(word.begin(), word.end(), text.begin(), [](char expected, char found) {
    return std::tolower(static_cast<unsigned char>(found)) == expected;
  });
}

bool is_word(std::string_view text, std::string_view word) {
  return text.size() == word.size() && starts_with_word(text, word);
}

}  // namespace inkbench
