// SPDX-License-Identifier: MIT
#include "app/workbench/recent_studies.h"

#include "app/workbench/user_folder.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/value.h"

namespace inkbench {
namespace {

/// An entry that every study of the list has.
std::string needed_text(const TomlReader& toml, const TomlNode& study, const std::string& key) {
  const TomlNode* node = study.find(key);
  if (node == nullptr) throw input_error(toml.at(study), "a study without " + key);
  return toml.text_of(*node, key);
}

}  // namespace

void add_recent_study(std::vector<RecentStudy>& studies, const RecentStudy& study) {
  std::erase_if(studies, [&](const RecentStudy& other) { return other.folder == study.folder; });
  studies.insert(studies.begin(), study);
  if (studies.size() > kMaxRecentStudies) studies.resize(kMaxRecentStudies);
}

std::vector<RecentStudy> load_recent_studies(const fs::path& file) {
  std::vector<RecentStudy> studies;
  std::error_code error;
  if (!fs::exists(file, error)) return studies;
  const TomlNode document = parse_toml(read_file(file, kMostTextBytes), file.string());
  const TomlReader toml(file.string());
  for (const TomlNode* study : toml.tables(document, "study")) {
    studies.push_back({needed_text(toml, *study, "title"), needed_text(toml, *study, "spec"),
                       needed_text(toml, *study, "folder")});
  }
  return studies;
}

void save_recent_studies(const fs::path& file, const std::vector<RecentStudy>& studies) {
  std::string text = "# The studies that the window ran, newest first.\n";
  for (const RecentStudy& study : studies) {
    const bool can_be_told = is_utf8(study.spec.string()) && is_utf8(study.folder.string());
    if (!can_be_told) continue;
    text += "\n[[study]]\ntitle = " + to_text(Value(study.title)) +
            "\nspec = " + to_text(Value(study.spec.string())) +
            "\nfolder = " + to_text(Value(study.folder.string())) + "\n";
  }
  write_file_atomically(file, text);
}

fs::path studies_folder() {
  if (const fs::path data = absolute_variable("XDG_DATA_HOME"); !data.empty())
    return data / "inkbench" / "studies";
  if (const fs::path home = absolute_variable("HOME"); !home.empty())
    return home / ".local" / "share" / "inkbench" / "studies";
  throw work_error("HOME", "is not set, so there is no place for studies",
                   "set HOME or XDG_DATA_HOME to a folder");
}

}  // namespace inkbench
