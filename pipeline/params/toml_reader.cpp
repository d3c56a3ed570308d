// SPDX-License-Identifier: MIT
#include "pipeline/params/toml_reader.h"

#include <algorithm>
#include <cmath>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {

std::string TomlReader::at(const TomlNode& node) const {
  return name_ + ":" + std::to_string(node.line);
}

const std::string& TomlReader::text_of(const TomlNode& node, const std::string& key) const {
  if (!node.is_text()) throw input_error(at(node), key + " is " + node.kind_name(), "it must be text");
  return node.text;
}

double TomlReader::number_of(const TomlNode& node, const std::string& key) const {
  if (node.kind == TomlNode::Kind::integer) return static_cast<double>(node.integer);
  if (node.kind == TomlNode::Kind::real && std::isfinite(node.real)) return node.real;
  throw input_error(at(node), key + " is " + node.kind_name(), "it must be a finite number");
}

const std::vector<TomlNode>& TomlReader::items_of(const TomlNode& node, const std::string& key) const {
  if (!node.is_array()) throw input_error(at(node), key + " is " + node.kind_name(), "it must be a list");
  return node.items;
}

const std::vector<TomlEntry>& TomlReader::entries_of(const TomlNode& node, const std::string& key) const {
  if (!node.is_table()) throw input_error(at(node), key + " is " + node.kind_name(), "it must be a table");
  return node.entries;
}

std::string TomlReader::text_entry(const TomlNode& table, const std::string& key,
                                   const std::string& fallback) const {
  const TomlNode* node = table.find(key);
  return node == nullptr ? fallback : text_of(*node, key);
}

std::vector<const TomlNode*> TomlReader::tables(const TomlNode& table, const std::string& key) const {
  std::vector<const TomlNode*> result;
  const TomlNode* list = table.find(key);
  if (list == nullptr) return result;
  const bool all_tables =
      list->is_array() && std::all_of(list->items.begin(), list->items.end(),
                                      [](const TomlNode& item) { return item.is_table(); });
  if (!all_tables)
    throw input_error(at(*list), key + " is " + list->kind_name(), "it must be tables: [[" + key + "]]");
  for (const TomlNode& item : list->items) result.push_back(&item);
  return result;
}

void TomlReader::check_keys(const TomlNode& table, const std::vector<std::string>& known) const {
  for (const auto& [key, node] : table.entries) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw input_error(at(node), "unknown entry '" + key + "'", suggest(key, known));
  }
}

}  // namespace inkbench
