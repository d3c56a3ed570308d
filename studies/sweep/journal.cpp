// SPDX-License-Identifier: MIT
#include "studies/sweep/journal.h"

#include <nlohmann/json.hpp>

#include <sstream>

#include "pipeline/base/files.h"

namespace inkbench {
namespace {

/// Errors (type_error): it is -1, 1.5, 1e300 or true, of each of which `get` would make a number.
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

/// Errors (json::exception): it is no record.
CellRecord record_of(const nlohmann::json& line) {
  CellRecord record{.index = count_of(line.at("cell")), .key = line.at("key")};
  record.numbers = line.at("numbers").get<std::vector<std::string>>();
  record.files = files_of(line.at("files"));
  if (!line.contains("numbers_key")) return record;
  record.numbers_key = line.at("numbers_key");
  record.origin = {line.at("drawing_sources"), line.at("measuring_sources"), line.at("renderer")};
  record.overlays = files_of(line.at("overlays"));
  return record;
}

}  // namespace

FileRecord record_file(const fs::path& folder, const std::string& name) {
  const std::string content = read_file(folder / name);
  return {name, content.size(), KeyBuilder().add(content).key().text()};
}

std::string journal_line(const CellRecord& record) {
  const nlohmann::ordered_json line{{"cell", record.index},
                                    {"key", record.key},
                                    {"numbers_key", record.numbers_key},
                                    {"drawing_sources", record.origin.drawing_sources},
                                    {"measuring_sources", record.origin.measuring_sources},
                                    {"renderer", record.origin.renderer},
                                    {"numbers", record.numbers},
                                    {"files", json_of(record.files)},
                                    {"overlays", json_of(record.overlays)}};
  return line.dump() + "\n";
}

std::map<size_t, CellRecord> read_journal(const fs::path& path) {
  std::map<size_t, CellRecord> records;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return records;
  std::istringstream lines(read_file(path));
  std::string text;
  while (std::getline(lines, text)) {
    try {
      CellRecord record = record_of(nlohmann::json::parse(text));
      records[record.index] = std::move(record);
    } catch (const nlohmann::json::exception&) {
      continue;  // torn by a kill: the cell is simply drawn again
    }
  }
  return records;
}

bool files_intact(const fs::path& folder, const std::vector<FileRecord>& files) {
  for (const FileRecord& file : files) {
    std::error_code error;
    if (fs::file_size(folder / file.name, error) != file.bytes || error) return false;
    if (record_file(folder, file.name).hash != file.hash) return false;
  }
  return true;
}

}  // namespace inkbench
