// SPDX-License-Identifier: MIT
#include "studies/sweep/journal.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string_view>

#include "pipeline/base/files.h"

namespace inkbench {
namespace {

/// The last entry of a line: the hash of all before it.
constexpr std::string_view kSumEntry = ",\"sum\":\"";
constexpr size_t kHashChars = 32;

/// Errors (json::exception): it is no record.
CellRecord record_of(const nlohmann::json& line) {
  CellRecord record{.index = count_of(line.at("cell")), .key = line.at("key")};
  record.numbers_key = line.at("numbers_key");
  record.origin = {line.at("drawing_sources"), line.at("measuring_sources"), line.at("renderer")};
  record.numbers = line.at("numbers").get<std::vector<std::string>>();
  record.files = files_of(line.at("files"));
  record.overlays = files_of(line.at("overlays"));
  return record;
}

std::string sum_entry(std::string_view before) {
  return std::string(kSumEntry) + KeyBuilder().add(before).key().text() + "\"}";
}

/// Does the line end in the hash of what stands before it?
bool sum_is_right(std::string_view line) {
  const size_t bytes = kSumEntry.size() + kHashChars + 2;
  if (line.size() < bytes) return false;
  const std::string_view before = line.substr(0, line.size() - bytes);
  return line.substr(before.size()) == sum_entry(before);
}

/// A whole line of an inkbench whose journal had no hashes, which ends in a list of files.
bool is_older(std::string_view line) {
  if (!line.ends_with("]}")) return false;
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  return json.is_object() && json.contains("cell") && json.contains("files") && !json.contains("sum");
}

std::optional<CellRecord> whole_record(std::string_view line) {
  if (!sum_is_right(line)) return std::nullopt;
  try {
    return record_of(nlohmann::json::parse(line));
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

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
  std::string text = line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  text.pop_back();
  return text + sum_entry(text) + "\n";
}

Journal read_journal(const fs::path& path) {
  Journal journal;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return journal;
  const std::string content = read_file(path);
  std::string_view rest = content;
  for (size_t number = 1; rest.find('\n') != std::string_view::npos; ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(line.size() + 1);
    if (std::optional<CellRecord> record = whole_record(line)) {
      journal.cells[record->index] = std::move(*record);
    } else if (is_older(line)) {
      ++journal.older;
    } else {
      journal.damaged.push_back(number);
    }
  }
  return journal;
}

}  // namespace inkbench
