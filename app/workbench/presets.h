// SPDX-License-Identifier: MIT
// Named presets: all settings as a TOML file each, in one folder. A preset is a scene file, so `inkbench
// render
// --scene` and studies read it as well. Marks lie beside it, in NAME.marks.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/workbench/painted_marks.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// Errors (input): a name that cannot be a file's: empty, over 100 bytes, with a control character or one of
/// / \ : * ? " < > |, with a point or blank at its start or end, or not UTF-8.
void check_preset_name(const std::string& name);

/// The settings as a preset of that name, for any file.
std::string preset_text(const std::string& name, const Settings& settings);

/// Whether the file is there and begins as a preset does: it was saved by inkbench and may be saved again.
bool is_preset_file(const std::filesystem::path& file);

class PresetStore {
 public:
  /// The folder need not be there yet; `user_folder() / "presets"` as a rule.
  explicit PresetStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path path_of(const std::string& name) const { return folder_ / (name + ".toml"); }

  /// The names, in order of the alphabet; no folder, no names. Files that cannot be presets are left out, but
  /// none is opened: a damaged preset shows when it is loaded.
  std::vector<std::string> list() const;
  bool contains(const std::string& name) const;

  /// Written whole or not at all; returns its path. Errors (input): a bad name, or one that exists unless
  /// `overwrite`; (work): the file cannot be written.
  std::filesystem::path save(const std::string& name, const Settings& settings, bool overwrite = false,
                             const PaintedMarks& marks = {}) const;

  /// Errors (input): a bad name, no such preset (with the nearest name), file:line of what is wrong in it.
  Settings load(const std::string& name) const;
  /// What was painted over its pictures; nothing where nothing was. Errors (input): as `parse_marks`.
  std::optional<PaintedMarks> marks(const std::string& name) const;

  /// Errors (input): a bad name, no such preset; (work): it cannot be removed.
  void remove(const std::string& name) const;

 private:
  std::filesystem::path marks_path_of(const std::string& name) const { return folder_ / (name + ".marks"); }
  void check_exists(const std::string& name) const;

  std::filesystem::path folder_;
};

/// Settings under the name that a comparison gives them.
struct NamedSettings {
  std::string name;
  Settings settings;
};

/// What differs between several settings: one row for each parameter that is not the same in all.
struct PresetTable {
  struct Row {
    std::string key;
    std::vector<std::optional<Value>> values;  ///< One for each name; empty where there is no such parameter.
  };
  std::vector<std::string> names;
  std::vector<Row> rows;  ///< In the order of files and tables.
};

PresetTable compare_settings(std::span<const NamedSettings> settings);

/// The table as text with columns in line, for the clipboard; "no parameter differs\n" without rows.
std::string table_text(const PresetTable& table);

}  // namespace inkbench
