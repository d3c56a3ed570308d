// SPDX-License-Identifier: MIT
#include "pipeline/settings/style_file.h"

#include <algorithm>
#include <array>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

/// What lines look like and what is drawn of them.
constexpr std::array<std::string_view, 3> kStyleGroups{"curves", "stroke", "ink"};

fs::path bundled_folder() {
  return project_file("data/styles");
}

std::string_view first_part(std::string_view key) {
  return key.substr(0, key.find('.'));
}

bool is_of_style(std::string_view key) {
  return std::find(kStyleGroups.begin(), kStyleGroups.end(), first_part(key)) != kStyleGroups.end();
}

TomlNode parsed(const fs::path& file) {
  return parse_toml(read_file(file, kMostTextBytes), file.string());
}

std::string line_of(std::string_view key, const Value& value) {
  return std::string(key) + " = " + to_text(value) + "\n";
}

/// All of `stroke` and its classes.
std::string stroke_lines(const Settings& settings) {
  std::string text;
  for (const ConstParam& param : list_params(settings)) {
    if (first_part(param.key) == "stroke") text += line_of(param.key, param.value());
  }
  return text;
}

}  // namespace

std::vector<std::string> style_names() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(bundled_folder())) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string style_title(const fs::path& file) {
  const TomlNode document = parsed(file);
  const TomlNode* title = document.find("title");
  return title != nullptr && title->is_text() ? title->text : "";
}

fs::path find_style(const std::string& name, const fs::path& folder, const std::string& where) {
  std::error_code error;
  const bool is_path = name.find('/') != std::string::npos || name.ends_with(".toml");
  const fs::path file = is_path ? folder / name : bundled_folder() / (name + ".toml");
  if (fs::is_regular_file(file, error)) return file;
  const std::vector<std::string> names = style_names();
  const std::string hint =
      is_path ? "give a style's file, or one of: " + join(names, ", ") : suggest(name, names);
  throw input_error(where, "there is no style " + printable(name), hint);
}

TomlNode read_style(const fs::path& file) {
  TomlNode document = parsed(file);
  std::erase_if(document.entries, [](const TomlEntry& entry) { return entry.key == "title"; });
  if (const TomlNode* other = document.find("style"))
    throw input_error(file.string() + ":" + std::to_string(other->line), "a style begins with no other one",
                      "give its parameters");
  Settings style;
  std::string others;
  const std::string name = file.string();
  apply_table(style, document, name, file.parent_path());
  visit_table(style, document, "", name, [&](const Param& param, const TomlNode& node) {
    if (!is_of_style(param.key))
      throw input_error(name + ":" + std::to_string(node.line), param.key + " is no part of a style",
                        "a style sets parameters of curves, stroke and ink");
    if (first_part(param.key) != "stroke") others += line_of(param.key, param.value());
  });
  return parse_toml(stroke_lines(style) + others, name);
}

void apply_style(Settings& settings, const std::string& name, const fs::path& folder,
                 const std::string& where) {
  const fs::path file = find_style(name, folder, where);
  apply_table(settings, read_style(file), file.string(), file.parent_path());
}

std::string style_text(const std::string& title, const Settings& settings) {
  std::string text = line_of("title", Value(title));
  const Settings defaults;
  for (const ConstParam& param : list_params(settings)) {
    if (!is_of_style(param.key)) continue;
    const bool is_default =
        first_part(param.key) == "stroke" && param.value() == find_param(defaults, param.key, "").value();
    if (!is_default) text += line_of(param.key, param.value());
  }
  return text;
}

}  // namespace inkbench
