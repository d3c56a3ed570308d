// SPDX-License-Identifier: MIT
// Walking a text mesh file by lines and tokens, and copying its numbers so that OpenMesh reads every one of
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/base/error.h"

namespace inkbench {

/// Lines of a text and the tokens within them, separated by blanks. Views stay valid as long as the text.
class TextCursor {
 public:
  TextCursor(std::string name, std::string_view text) : name_(std::move(name)), rest_(text) {}

  /// Moves to the next line (without "\n"); false at the end of the text.
  bool next_line();
  /// The next token of the current line, "" at its end.
  std::string_view token();
  /// The next token, on a later line if need be, "" at the end of the text.
  std::string_view token_across_lines();
  /// Ends the current line where a "#" begins a comment.
  void cut_comment();

  std::string_view line() const { return line_; }
  /// What follows the current line.
  std::string_view rest() const { return rest_; }
  const std::string& name() const { return name_; }
  /// An input error at the current line.
  Error error(const std::string& what, const std::string& expected = "") const;

 private:
  std::string name_;
  std::string_view rest_;
  std::string_view line_;
  std::string_view line_rest_;
  size_t line_number_ = 0;  ///< Counted from 1.
};

/// The token in quotes for a message: its beginning, what cannot be printed as "?".
std::string shown(std::string_view token);

/// Appends the token, a blank after it; where it is NaN, infinite or too large for a float, `kNotFinite`
/// instead. False where it is no number.
bool append_number(std::string_view token, std::string& out);

/// Appends the integer, a blank after it; one too large for 32 bits is brought to their limit (it names no
/// vertex either way). False where it is none.
bool append_integer(std::string_view token, std::string& out);

/// The next three tokens of the line as numbers, appended. Errors (input): too few, or not numbers; `what`
/// names them ("a vertex").
void append_three_numbers(TextCursor& cursor, const std::string& what, std::string& out);

/// The token as a count, if it is one.
std::optional<uint64_t> parse_count(std::string_view token);

/// Does the text begin with `word` (lower case), whatever the text's case?
bool starts_with_word(std::string_view text, std::string_view word);

/// "truncated: the header announces V vertices and F faces, but the file holds v and f".
Error truncation_error(const std::string& name, uint64_t announced_vertices, uint64_t announced_faces,
                       uint64_t found_vertices, uint64_t found_faces);

}  // namespace inkbench
