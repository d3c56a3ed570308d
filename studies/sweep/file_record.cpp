// SPDX-License-Identifier: MIT
#include "studies/sweep/file_record.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/key.h"

namespace inkbench {

FileRecord record_file(const fs::path& folder, const std::string& name) {
  const std::string content = read_file(folder / name);
  return {name, content.size(), KeyBuilder().add(content).key().text()};
}

std::string file_problem(const fs::path& folder, const FileRecord& file) {
  std::error_code error;
  if (!fs::exists(folder / file.name, error)) return "is missing";
  if (fs::file_size(folder / file.name, error) != file.bytes || error) return "was changed";
  try {
    return record_file(folder, file.name).hash == file.hash ? "" : "was changed";
  } catch (const Error& cause) {
    return std::string("cannot be read: ") + cause.what();
  }
}

bool files_intact(const fs::path& folder, const std::vector<FileRecord>& files) {
  return std::all_of(files.begin(), files.end(),
                     [&](const FileRecord& file) { return file_problem(folder, file).empty(); });
}

uint64_t count_of(const nlohmann::json& value) {
  return value.get_ref<const nlohmann::json::number_unsigned_t&>();
}

nlohmann::ordered_json json_of(const std::vector<FileRecord>& files) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const FileRecord& file : files)
    json.push_back({{"name", file.name}, {"bytes", file.bytes}, {"hash", file.hash}});
  return json;
}

std::vector<FileRecord> files_of(const nlohmann::json& json) {
  std::vector<FileRecord> files;
  for (const nlohmann::json& file : json)
    files.push_back({file.at("name"), count_of(file.at("bytes")), file.at("hash")});
  return files;
}

}  // namespace inkbench
