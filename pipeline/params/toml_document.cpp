#include "pipeline/params/toml_document.h"

#include <toml++/toml.h>

#include <algorithm>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

std::string place(const std::string& name, int line) {
  return name + ":" + std::to_string(line);
}

TomlNode convert(const toml::node& source, const std::string& name);

TomlNode convert_table(const toml::table& table, const std::string& name) {
  TomlNode node;
  for (const auto& [key, value] : table) node.entries.emplace_back(std::string(key.str()), convert(value, name));
  std::stable_sort(node.entries.begin(), node.entries.end(),
                   [](const auto& a, const auto& b) { return a.second.line < b.second.line; });
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
    throw input_error(place(name, node.line), "a date or time", "a number, text, true or false is needed here");
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
  try {
    const toml::table table = toml::parse(text);
    return convert_table(table, name);
  } catch (const toml::parse_error& error) {
    throw input_error(place(name, static_cast<int>(error.source().begin.line)),
                      "not valid TOML: " + std::string(error.description()));
  }
}

}  // namespace inkbench
