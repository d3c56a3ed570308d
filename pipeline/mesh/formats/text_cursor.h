// SPDX-License-Identifier: MIT
// Walks a text mesh file by lines and tokens. In: the text, whose lines may end in LF, CR LF or CR. Out:
// views of its tokens, and errors that name the line.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/base/error.h"

namespace inkbench {

struct TextRules {
  bool has_comments = false;  ///< A token that begins with "#" ends its line.
  bool joins_lines = false;   ///< A backslash before a line end is a blank, and so is the line end.
};

/// Stands within the first line at first. `name` and the text must outlive it; a copy looks ahead.
class TextCursor {
 public:
  TextCursor(const std::string& name, std::string_view text, const TextRules& rules = {});

  /// Moves to the next line; false at the end of the text.
  bool next_line();
  /// The next token of the current line, "" at its end. Blanks separate tokens.
  std::string_view token();
  /// The next token, on a later line if need be, "" at the end of the text.
  std::string_view token_across_lines();
  /// Puts back the end of the last token, from `begin` on.
  void put_back_from(const char* begin) { at_ = begin; }

  bool is_at_end() const { return at_ == end_; }
  /// How many bytes are left.
  size_t left() const { return static_cast<size_t>(end_ - at_); }
  /// What follows the current line.
  std::string_view rest() const;
  /// The line of the last token, for messages.
  std::string_view line() const;
  const std::string& name() const { return *name_; }
  /// An input error at the last token's line.
  Error error(const std::string& what, const std::string& expected = "") const;

 private:
  const char* line_end(const char* from) const;
  const char* after_line_end(const char* line_end) const;
  const char* joined_line(const char* backslash) const;

  const std::string* name_;
  TextRules rules_;
  const char* begin_;
  const char* end_;
  const char* at_;
  const char* mark_;               ///< Where the last token began.
  bool has_lone_returns_ = false;  ///< Lines end in CR, so that a LF after one is a line end of its own.
};

/// The token in quotes for a message: its beginning, what cannot be printed as "?".
std::string shown(std::string_view token);

/// Does the text begin with `word` (lower case), whatever the text's case?
bool starts_with_word(std::string_view text, std::string_view word);
/// Is it `word` (lower case), whatever its case?
bool is_word(std::string_view text, std::string_view word);

}  // namespace inkbench
