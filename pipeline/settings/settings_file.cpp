// SPDX-License-Identifier: MIT
#include "pipeline/settings/settings_file.h"

#include <algorithm>
#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/style_file.h"

namespace inkbench {
namespace {

constexpr int kMaxBaseDepth = 16;

struct Source {
  std::string name;
  fs::path folder;
  std::vector<fs::path> open_files;  ///< The chain of `base` files being read, to find circles.

  std::string at(const TomlNode& node) const { return name + ":" + std::to_string(node.line); }
};

Settings read_settings(const TomlNode& document, const Source& source);

Settings read_settings_file(const fs::path& path, std::vector<fs::path> open_files) {
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  if (std::find(open_files.begin(), open_files.end(), resolved) != open_files.end()) {
    throw input_error(open_files.back().string(), "`base` leads back to " + resolved.string(),
                      "scene files may not refer to each other in a circle");
  }
  if (open_files.size() >= kMaxBaseDepth) throw input_error(path.string(), "`base` is nested too deeply");
  open_files.push_back(resolved);
  const TomlNode document = parse_toml(read_file(path, kMostTextBytes), path.string());
  return read_settings(document, {path.string(), path.parent_path(), open_files});
}

std::string checked_name(const TomlNode& item, const std::string& list, const Source& source) {
  const TomlNode* name = item.find("name");
  if (name == nullptr || !name->is_text()) {
    throw input_error(source.at(item), "a [[" + list + "]] without a name", "give it one: name = \"box\"");
  }
  const bool plain = !name->text.empty() && name->text.find_first_not_of(
                                                "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                "0123456789_-") == std::string::npos;
  if (!plain) {
    throw input_error(source.at(*name), "the name \"" + name->text + "\" cannot be part of a key",
                      "use letters, digits, _ and -");
  }
  return name->text;
}

bool is_group(const Settings& settings, const std::string& prefix) {
  const std::vector<ConstParamGroup> groups = list_groups(settings);
  return prefix == "model" || prefix == "light" ||
         std::any_of(groups.begin(), groups.end(),
                     [&](const ConstParamGroup& group) { return group.prefix == prefix; });
}

/// Sets every value below `table`, whose own key is `prefix`.
void apply_entries(Settings& settings, const TomlNode& table, const std::string& prefix,
                   const Source& source) {
  visit_table(settings, table, prefix, source.name, [&](const Param& param, const TomlNode& node) {
    param.set(value_from_toml(param, node, source.at(node), source.folder.string()), source.at(node));
  });
}

/// One [[model]] or [[light]] list: a new name adds one, a name that the base scene has changes it.
template <class Item>
void apply_list(Settings& settings, std::vector<Item>& items, const std::string& list, const TomlNode& array,
                const Source& source) {
  std::set<std::string> seen, known;
  for (const Item& item : items) known.insert(item.name);
  for (const TomlNode& table : array.items) {
    if (!table.is_table())
      throw input_error(source.at(array), list + " holds " + table.kind_name(), "it is a list of tables");
    const std::string name = checked_name(table, list, source);
    if (!seen.insert(name).second) {
      throw input_error(source.at(table), "a second [[" + list + "]] is named '" + name + "'",
                        "names must differ");
    }
    if (items.size() >= kMaxModels)
      throw input_error(source.at(table), "too many [[" + list + "]] tables",
                        "at most " + std::to_string(kMaxModels));
    if (known.insert(name).second) {
      items.emplace_back();
      items.back().name = name;
    }
    TomlNode rest = table;
    std::erase_if(rest.entries, [](const auto& entry) { return entry.key == "name"; });
    apply_entries(settings, rest, list + "." + name, source);
  }
}

void apply_document(Settings& settings, const TomlNode& document, const Source& source) {
  if (const TomlNode* title = document.find("title"); title != nullptr && !title->is_text()) {
    throw input_error(source.at(*title), "title is " + title->kind_name(), "it must be text");
  }
  TomlNode rest = document;
  std::erase_if(rest.entries, [](const auto& entry) { return entry.key == "base" || entry.key == "title"; });
  for (const char* list : {"model", "light"}) {
    const TomlNode* array = document.find(list);
    if (array == nullptr || !array->is_array()) continue;
    if (std::string_view(list) == "model") apply_list(settings, settings.models, list, *array, source);
    if (std::string_view(list) == "light") apply_list(settings, settings.lights, list, *array, source);
    std::erase_if(rest.entries, [&](const auto& entry) { return entry.key == list; });
  }
  apply_entries(settings, rest, "", source);
}

Settings read_settings(const TomlNode& document, const Source& source) {
  Settings settings;
  if (const TomlNode* base = document.find("base")) {
    if (!base->is_text())
      throw input_error(source.at(*base), "base is " + base->kind_name(), "it must be a scene file's path");
    try {
      settings = read_settings_file(source.folder / base->text, source.open_files);
    } catch (const Error& error) {
      throw input_error(source.at(*base), "base: " + std::string(error.what()));
    }
  }
  apply_document(settings, document, source);
  return settings;
}

/// The entry `style` of a table, whose values the table's others may change.
void visit_style(Settings& settings, const TomlNode& table, const std::string& name,
                 const ParamVisitor& visit) {
  const TomlNode* style = table.find("style");
  if (style == nullptr) return;
  const std::string where = name + ":" + std::to_string(style->line);
  if (!style->is_text())
    throw input_error(where, "style is " + style->kind_name(), "it must be a style's name or file");
  const TomlNode values = read_style(find_style(style->text, fs::path(name).parent_path(), where));
  visit_table(settings, values, "", where, visit);
}

void append_fields(std::string& text, const ConstParamGroup& group, const std::string& key_prefix) {
  for (const Field& field : group.description->fields) {
    text += key_prefix + std::string(field.name) + " = " + to_text(field.get(group.owner)) + "\n";
  }
}

}  // namespace

Settings load_settings(const fs::path& path) {
  return read_settings_file(path, {});
}

Settings parse_settings(std::string_view text, const std::string& name, const fs::path& folder) {
  return parse_settings(parse_toml(text, name), name, folder);
}

Settings parse_settings(const TomlNode& document, const std::string& name, const fs::path& folder) {
  return read_settings(document, {name, folder, {}});
}

void apply_table(Settings& settings, const TomlNode& table, const std::string& name, const fs::path& folder) {
  apply_entries(settings, table, "", {name, folder, {}});
}

void visit_table(Settings& settings, const TomlNode& table, const std::string& prefix,
                 const std::string& name, const ParamVisitor& visit) {
  std::vector<Param> seen;
  if (prefix.empty()) visit_style(settings, table, name, visit);
  for (const auto& [part, node] : table.entries) {
    const std::string key = prefix.empty() ? part : prefix + "." + part;
    if (key == "style") continue;
    const std::string where = name + ":" + std::to_string(node.line);
    if (part.find('.') != std::string::npos) {
      throw input_error(where, "the key '" + part + "' is quoted, so its dots do not separate parts",
                        "leave the quotes out");
    }
    const bool is_empty_group = node.is_table() && node.entries.empty() && is_group(settings, key);
    if (is_empty_group) continue;
    if (node.is_table() && !node.entries.empty()) {
      visit_table(settings, node, key, name, visit);
      continue;
    }
    const Param param = find_param(settings, key, where);
    for (const Param& other : seen) {
      if (param.overlaps(other))
        throw input_error(where, key + " and " + other.key + " are the same", "give one of them");
    }
    seen.push_back(param);
    visit(param, node);
  }
}

std::string settings_text(const Settings& settings) {
  std::string plain;
  std::string lists;
  for (const ConstParamGroup& group : list_groups(settings)) {
    const std::vector<std::string> parts = split(group.prefix, '.');
    const bool is_of_list = parts.front() == "model" || parts.front() == "light";
    if (!is_of_list) {
      plain += "[" + group.prefix + "]\n";
      append_fields(plain, group, "");
    } else if (parts.size() == 2) {
      lists += "[[" + parts[0] + "]]\nname = " + to_text(Value(parts[1])) + "\n";
      append_fields(lists, group, "");
    } else {
      append_fields(lists, group, parts[2] + ".");
    }
  }
  return plain + lists;
}

}  // namespace inkbench
