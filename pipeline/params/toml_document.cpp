// SPDX-License-Identifier: MIT
#include "pipeline/params/toml_document.h"

#include <toml++/toml.h>

#include <algorithm>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr int kMaxKeyParts = 16;

std::string place(const std::string& name, int line) {
  return name + ":" + std::to_string(line);
}

/// Where the string that opens at `begin` closes; the end of its line or of the text where it does not.
size_t string_end(std::string_view text, size_t begin) {
  const char quote = text[begin];
  const bool is_long = text.substr(begin, 3) == std::string(3, quote);
  const std::string_view closing = text.substr(begin, is_long ? 3 : 1);
  for (size_t i = begin + closing.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i, closing.size()) == closing) {
      return i + closing.size() - 1;
    } else if (text[i] == '\n' && !is_long) {
      return i - 1;
    }
  }
  return text.size() - 1;
}

/// toml++ limits how deep values nest but not how many parts a dotted key has, and recurses into each: a long
/// one would overflow the stack. Errors (input): a key of more parts than any parameter has.
void check_key_lengths(std::string_view text, const std::string& name) {
  int parts = 1;
  int line = 1;
  for (size_t i = 0; i < text.size(); ++i) {
    const size_t begin = i;
    if (text[i] == '"' || text[i] == '\'') i = string_end(text, i);
    if (text[i] == '#') i = std::min(text.find('\n', i), text.size()) - 1;
    line += static_cast<int>(std::count(text.begin() + begin, text.begin() + i + 1, '\n'));
    if (text[i] == '.') ++parts;
    if (std::string_view("=,[]{}\n").find(text[i]) != std::string_view::npos) parts = 1;
    if (parts > kMaxKeyParts)
      throw input_error(place(name, line), "a key of too many parts",
                        "at most " + std::to_string(kMaxKeyParts));
  }
}

TomlNode convert(const toml::node& source, const std::string& name);

TomlNode convert_table(const toml::table& table, const std::string& name) {
  TomlNode node;
  for (const auto& [key, value] : table)
    node.entries.push_back({std::string(key.str()), convert(value, name)});
  std::stable_sort(node.entries.begin(), node.entries.end(),
                   [](const auto& a, const auto& b) { return a.node.line < b.node.line; });
  return node;
}

TomlNode convert(const toml::node& source, const std::string& name) {
  TomlNode node;
  if (const toml::table* table = source.as_table()) node = convert_table(*table, name);
  node.line = static_cast<int>(source.source().begin.line);
  if (const toml::array* array = source.as_array()) {
    node.kind = TomlNode::Kind::array;
    for (const toml::node& item : *array) node.items.push_back(convert(item, name));
  } else if (const auto* boolean = source.as_boolean()) {
    node.kind = TomlNode::Kind::boolean;
    node.boolean = boolean->get();
  } else if (const auto* integer = source.as_integer()) {
    node.kind = TomlNode::Kind::integer;
    node.integer = integer->get();
  } else if (const auto* real = source.as_floating_point()) {
    node.kind = TomlNode::Kind::real;
    node.real = real->get();
  } else if (const auto* text = source.as_string()) {
    node.kind = TomlNode::Kind::text;
    node.text = text->get();
  } else if (!source.is_table()) {
    throw input_error(place(name, node.line), "a date or time",
                      "a number, text, true or false is needed here");
  }
  return node;
}

}  // namespace

const TomlNode* TomlNode::find(std::string_view key) const {
  for (const auto& [name, node] : entries) {
    if (name == key) return &node;
  }
  return nullptr;
}

std::string TomlNode::kind_name() const {
  switch (kind) {
    case Kind::boolean:
      return boolean ? "true" : "false";
    case Kind::integer:
    case Kind::real:
      return "a number";
    case Kind::text:
      return "the text \"" + text.substr(0, 60) + "\"";
    case Kind::array:
      return "a list of " + std::to_string(items.size());
    case Kind::table:
      return "a table";
  }
  return "";
}

TomlNode parse_toml(std::string_view text, const std::string& name) {
  check_key_lengths(text, name);
  try {
    const toml::table table = toml::parse(text);
    return convert_table(table, name);
  } catch (const toml::parse_error& error) {
    throw input_error(place(name, static_cast<int>(error.source().begin.line)),
                      "not valid TOML: " + std::string(error.description()));
  }
}

}  // namespace inkbench
