// SPDX-License-Identifier: MIT
// What every reader of a TOML document asks of its nodes: that they are of a kind, and that nothing is in a
// table that is not known. Errors (input) name the document and the line.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/params/toml_document.h"

namespace inkbench {

class TomlReader {
 public:
  /// `name`: of the document, for errors.
  explicit TomlReader(std::string name) : name_(std::move(name)) {}

  /// "paper.toml:12".
  std::string at(const TomlNode& node) const;

  /// The node's content, where it must be of that kind; `key` names it in errors.
  const std::string& text_of(const TomlNode& node, const std::string& key) const;
  double number_of(const TomlNode& node, const std::string& key) const;  ///< A finite one.
  const std::vector<TomlNode>& items_of(const TomlNode& node, const std::string& key) const;
  const std::vector<TomlEntry>& entries_of(const TomlNode& node, const std::string& key) const;

  /// The text of the table's entry, or `fallback` where there is none.
  std::string text_entry(const TomlNode& table, const std::string& key, const std::string& fallback) const;

  /// Every [[key]] of the table; none where there is no such list.
  std::vector<const TomlNode*> tables(const TomlNode& table, const std::string& key) const;

  void check_keys(const TomlNode& table, const std::vector<std::string>& known) const;

 private:
  std::string name_;
};

}  // namespace inkbench
