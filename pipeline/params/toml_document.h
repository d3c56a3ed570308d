// SPDX-License-Identifier: MIT
// A TOML document as a plain tree with line numbers. toml++ stays behind toml_document.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

struct TomlEntry;

struct TomlNode {
  enum class Kind { boolean, integer, real, text, array, table };

  Kind kind = Kind::table;
  bool boolean = false;
  int64_t integer = 0;
  double real = 0.0;
  std::string text;
  std::vector<TomlNode> items;     ///< Of an array.
  std::vector<TomlEntry> entries;  ///< Of a table, in the document's order of lines.
  int line = 0;

  /// The entry of that key, or nullptr.
  const TomlNode* find(std::string_view key) const;
  bool is_table() const { return kind == Kind::table; }
  bool is_array() const { return kind == Kind::array; }
  bool is_text() const { return kind == Kind::text; }
  /// "a number", "a table": what the node is, for errors.
  std::string kind_name() const;
};

struct TomlEntry {
  std::string key;
  TomlNode node;
};

/// Parses a whole document. Errors (input): `name:line` and what the grammar objects to; a key given twice; a
/// date or time, which no setting takes.
TomlNode parse_toml(std::string_view text, const std::string& name);

}  // namespace inkbench
