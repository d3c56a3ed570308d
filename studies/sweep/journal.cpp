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

}  // namespace

FileRecord record_file(const fs::path& folder, const std::string& name) {
  const std::string content = read_file(folder / name);
  return {name, content.size(), KeyBuilder().add(content).key().text()};
}

std::string journal_line(const CellRecord& record) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const FileRecord& file : record.files)
    files.push_back({{"name", file.name}, {"bytes", file.bytes}, {"hash", file.hash}});
  const nlohmann::ordered_json line{
      {"cell", record.index}, {"key", record.key}, {"numbers", record.numbers}, {"files", files}};
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
      const nlohmann::json line = nlohmann::json::parse(text);
      CellRecord record{count_of(line.at("cell")), line.at("key"), line.at("numbers"), {}};
      for (const nlohmann::json& file : line.at("files"))
        record.files.push_back({file.at("name"), count_of(file.at("bytes")), file.at("hash")});
      records[record.index] = std::move(record);
    } catch (const nlohmann::json::exception&) {
      continue;  // torn by a kill: the cell is simply drawn again
    }
  }
  return records;
}

bool files_intact(const fs::path& folder, const CellRecord& record) {
  for (const FileRecord& file : record.files) {
    std::error_code error;
    if (fs::file_size(folder / file.name, error) != file.bytes || error) return false;
    if (record_file(folder, file.name).hash != file.hash) return false;
  }
  return true;
}

}  // namespace inkbench
