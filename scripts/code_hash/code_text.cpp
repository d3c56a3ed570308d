// SPDX-License-Identifier: MIT
#include "scripts/code_hash/code_text.h"

#include <algorithm>
#include <cctype>

namespace inkbench {
namespace {

constexpr std::string_view kHelp = ".help=";

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

class Reader {
 public:
  explicit Reader(std::string_view source) : source_(source) {}

  std::string read() {
    while (at_ < source_.size()) step();
    return std::move(code_);
  }

 private:
  char next() const { return at_ + 1 < source_.size() ? source_[at_ + 1] : '\0'; }

  void step() {
    const char c = source_[at_];
    if (is_space(c)) {
      skip_space();
    } else if (c == '/' && next() == '/') {
      skip_to("\n");
    } else if (c == '/' && next() == '*') {
      at_ += 2;
      skip_to("*/");
      at_ = std::min(at_ + 2, source_.size());
      space_ = true;
    } else if (c == '"') {
      take_text(text_end());
    } else if (c == '\'' && !(at_ > 0 && is_word(source_[at_ - 1]))) {  // 10'000 is a number
      take_text(quoted_end('\''));
    } else {
      take(c);
    }
  }

  void skip_to(std::string_view mark) { at_ = std::min(source_.find(mark, at_), source_.size()); }

  /// The end of a line ends a directive; elsewhere it is a space.
  void skip_space() {
    for (; at_ < source_.size() && is_space(source_[at_]); ++at_) {
      const bool is_continued = at_ > 0 && source_[at_ - 1] == '\\';
      if (source_[at_] != '\n' || !in_directive_ || is_continued) continue;
      code_ += '\n';
      in_directive_ = false;
    }
    space_ = true;
  }

  void take(char c) {
    const bool at_line_start = code_.empty() || code_.back() == '\n';
    if (c == '#' && !in_directive_) {
      if (!at_line_start) code_ += '\n';
      in_directive_ = true;
    }
    if (space_ && !code_.empty() && is_word(code_.back()) && is_word(c)) code_ += ' ';
    space_ = false;
    in_help_ = false;
    code_ += c;
    ++at_;
  }

  size_t quoted_end(char quote) const {
    size_t end = at_ + 1;
    while (end < source_.size() && source_[end] != quote) end += source_[end] == '\\' ? 2 : 1;
    return std::min(end + 1, source_.size());
  }

  /// Of a string, which is raw after an R.
  size_t text_end() const {
    if (code_.empty() || code_.back() != 'R' || space_) return quoted_end('"');
    const size_t open = source_.find('(', at_);
    if (open == std::string_view::npos) return source_.size();
    const std::string close = ")" + std::string(source_.substr(at_ + 1, open - at_ - 1)) + "\"";
    const size_t end = source_.find(close, open);
    return end == std::string_view::npos ? source_.size() : end + close.size();
  }

  /// A string or character, unless it belongs to a help text.
  void take_text(size_t end) {
    const bool is_help = in_help_ || code_.ends_with(kHelp);
    if (!is_help) code_ += source_.substr(at_, end - at_);
    in_help_ = is_help;
    space_ = false;
    at_ = end;
  }

  std::string_view source_;
  std::string code_;
  size_t at_ = 0;
  bool space_ = false, in_directive_ = false, in_help_ = false;
};

}  // namespace

std::string code_text(std::string_view source) {
  return Reader(source).read();
}

}  // namespace inkbench
