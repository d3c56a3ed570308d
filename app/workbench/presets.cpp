// SPDX-License-Identifier: MIT
#include "app/workbench/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/workbench/param_changes.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/settings/settings_file.h"
#include "studies/sweep/labels.h"

namespace inkbench {
namespace {

constexpr size_t kMaxNameBytes = 100;

/// What is wrong with the name, or "".
std::string name_fault(const std::string& name) {
  if (name.empty()) return "is empty";
  if (name.size() > kMaxNameBytes) return fmt::format("is longer than {} bytes", kMaxNameBytes);
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) return "has a control character";
    if (std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos)
      return fmt::format("has the character {}", c);
  }
  if (std::string_view(". ").find(name.front()) != std::string_view::npos ||
      std::string_view(". ").find(name.back()) != std::string_view::npos)
    return "starts or ends with a point or a blank";
  return is_utf8(name) ? "" : "is not UTF-8";
}

/// Code points of UTF-8.
size_t letters_in(const std::string& text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(),
                                           [](char c) { return (static_cast<uint8_t>(c) & 0xc0) != 0x80; }));
}

/// A value as a number behind its label: equal values have equal numbers. For ramps, whose texts are long.
std::string numbered(const PresetTable::Row& row, const Value& value) {
  std::vector<Value> distinct;
  for (const std::optional<Value>& other : row.values) {
    if (other && std::find(distinct.begin(), distinct.end(), *other) == distinct.end())
      distinct.push_back(*other);
  }
  const auto place = std::find(distinct.begin(), distinct.end(), value) - distinct.begin();
  return fmt::format("{} ({})", label_text(value), place + 1);
}

/// The row's values: short ones, unless values that differ would look the same.
std::vector<std::string> row_texts(const PresetTable::Row& row) {
  std::map<std::string, Value> shown;
  bool tells = true;
  for (const std::optional<Value>& value : row.values) {
    if (value) tells = tells && shown.emplace(label_text(*value), *value).first->second == *value;
  }
  std::vector<std::string> texts;
  for (const std::optional<Value>& value : row.values) {
    texts.push_back(!value                                 ? "-"
                    : tells                                ? label_text(*value)
                    : std::holds_alternative<Ramp>(*value) ? numbered(row, *value)
                                                           : to_text(*value));
  }
  return texts;
}

}  // namespace

void check_preset_name(const std::string& name) {
  const std::string fault = name_fault(name);
  if (fault.empty()) return;
  throw input_error("preset", "the name " + fault, "use letters, digits, blanks, - and _");
}

std::string preset_text(const std::string& name, const Settings& settings) {
  return fmt::format("{}: {}\n{}", kPresetMark, name, settings_text(settings));
}

bool is_preset_file(const fs::path& file) {
  try {
    return read_file_part(file, 0, kPresetMark.size()) == kPresetMark;
  } catch (const Error&) {
    return false;
  }
}

std::vector<std::string> PresetStore::list() const {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().stem().string();
    std::error_code status;
    if (entry->path().extension() == ".toml" && entry->is_regular_file(status) && name_fault(name).empty())
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool PresetStore::contains(const std::string& name) const {
  std::error_code error;
  return name_fault(name).empty() && fs::is_regular_file(path_of(name), error);
}

void PresetStore::check_exists(const std::string& name) const {
  check_preset_name(name);
  if (!contains(name))
    throw input_error("preset", "there is none named '" + name + "'", suggest(name, list()));
}

fs::path PresetStore::save(const std::string& name, const Settings& settings, bool overwrite,
                           const PaintedMarks& marks) const {
  check_preset_name(name);
  std::error_code error;
  if (!overwrite && fs::exists(path_of(name), error))
    throw input_error("preset", "there is one named '" + name + "' already",
                      "overwrite it or choose another name");
  remove_abandoned_files(folder_);
  write_file_atomically(path_of(name), preset_text(name, settings));
  fs::remove(marks_path_of(name), error);
  if (!marks.empty()) write_file_atomically(marks_path_of(name), marks_text(marks));
  return path_of(name);
}

Settings PresetStore::load(const std::string& name) const {
  check_exists(name);
  return load_settings(path_of(name));
}

std::optional<PaintedMarks> PresetStore::marks(const std::string& name) const {
  const fs::path file = marks_path_of(name);
  std::error_code error;
  if (name_fault(name) != "" || !fs::is_regular_file(file, error)) return std::nullopt;
  return parse_marks(read_file(file), file.string());
}

void PresetStore::remove(const std::string& name) const {
  check_exists(name);
  std::error_code error;
  fs::remove(path_of(name), error);
  if (error) throw work_error(path_of(name).string(), "cannot be removed: " + error.message());
  fs::remove(marks_path_of(name), error);
}

PresetTable compare_settings(std::span<const NamedSettings> settings) {
  PresetTable table;
  std::set<std::string> differing;
  std::vector<Settings> copies;
  for (const NamedSettings& item : settings) {
    table.names.push_back(item.name);
    copies.push_back(item.settings);
    for (const ParamChange& change : changed_params(settings.front().settings, item.settings))
      differing.insert(change.key);
  }
  std::set<std::string> seen;
  for (const Settings& order : copies) {
    for (const ConstParam& param : list_params(order)) {
      if (!differing.contains(param.key) || !seen.insert(param.key).second) continue;
      PresetTable::Row row{param.key, {}};
      for (const Settings& side : copies) {
        row.values.push_back(has_param(side, param.key)
                                 ? std::optional(find_param(side, param.key, "compare").value())
                                 : std::nullopt);
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::string table_text(const PresetTable& table) {
  if (table.rows.empty()) return "no parameter differs\n";
  std::vector<std::vector<std::string>> lines{{"parameter"}};
  lines[0].insert(lines[0].end(), table.names.begin(), table.names.end());
  for (const PresetTable::Row& row : table.rows) {
    lines.push_back(row_texts(row));
    lines.back().insert(lines.back().begin(), row.key);
  }
  std::vector<size_t> widths(lines[0].size());
  for (const auto& line : lines) {
    for (size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], letters_in(line[i]));
  }
  std::string text;
  for (const auto& line : lines) {
    std::string padded;
    for (size_t i = 0; i < line.size(); ++i)
      padded += line[i] + std::string(widths[i] - letters_in(line[i]) + 2, ' ');
    padded.erase(padded.find_last_not_of(' ') + 1);
    text += padded + "\n";
  }
  return text;
}

}  // namespace inkbench
