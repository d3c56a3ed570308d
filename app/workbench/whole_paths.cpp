// SPDX-License-Identifier: MIT
#include "app/workbench/whole_paths.h"

#include <utility>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_document.h"
#include "pipeline/params/value.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

/// Below a table of parameters or a list of values. Choices and the like have no ending.
void add_files(const TomlNode* node, std::vector<const TomlNode*>& nodes) {
  if (node == nullptr) return;
  const fs::path path = node->text;
  if (node->is_text() && path.is_relative() && path.has_extension()) nodes.push_back(node);
  for (const TomlNode& item : node->items) add_files(&item, nodes);
  for (const TomlEntry& entry : node->entries) add_files(&entry.node, nodes);
}

/// A scene that does not lie beside the spec is the project's.
bool is_beside(const TomlNode* scene, const fs::path& folder) {
  std::error_code error;
  return scene != nullptr && scene->is_text() && fs::path(scene->text).is_relative() &&
         fs::is_regular_file(folder / scene->text, error);
}

std::vector<const TomlNode*> path_nodes(const TomlNode& spec, const fs::path& folder) {
  std::vector<const TomlNode*> nodes;
  if (const TomlNode* scene = spec.find("scene"); is_beside(scene, folder)) nodes.push_back(scene);
  add_files(spec.find("set"), nodes);
  constexpr std::pair<const char*, const char*> kPlaces[] = {
      {"axis", "values"}, {"variant", "set"}, {"view", "set"}};
  for (const auto& [list, key] : kPlaces) {
    const TomlNode* tables = spec.find(list);
    if (tables == nullptr) continue;
    for (const TomlNode& table : tables->items) add_files(table.find(key), nodes);
  }
  return nodes;
}

}  // namespace

std::string with_whole_paths(const std::string& text, const fs::path& folder) {
  std::vector<std::string> lines = split(text, '\n');
  try {
    const TomlNode spec = parse_toml(text, "");
    for (const TomlNode* node : path_nodes(spec, folder)) {
      std::string& line = lines.at(static_cast<size_t>(node->line) - 1);
      const std::string whole = to_text(Value((folder / node->text).lexically_normal().string()));
      for (const std::string& written : {to_text(Value(node->text)), "'" + node->text + "'"}) {
        const size_t place = line.find(written);
        if (place == std::string::npos) continue;
        line.replace(place, written.size(), whole);
        break;
      }
    }
  } catch (const Error&) {
    return text;
  }
  return join(lines, "\n");
}

}  // namespace inkbench
