// SPDX-License-Identifier: MIT
#include "studies/sweep/verify_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/stop.h"
#include "studies/report/csv.h"
#include "studies/sweep/journal.h"

namespace inkbench {
namespace {

class Verification {
 public:
  explicit Verification(const fs::path& folder)
      : folder_(folder), journal_(read_journal(folder / "journal.jsonl")) {}

  StudyCheck run() {
    check_manifest();
    check_journal();
    check_data();
    return std::move(check_);
  }

 private:
  void add_problem(std::string text) { check_.problems.push_back(std::move(text)); }

  void check_files(const std::vector<FileRecord>& files) {
    for (const FileRecord& file : files) {
      stop_if_asked();
      if (!seen_.insert(file.name).second) continue;
      ++check_.files;
      const std::string problem = file_problem(folder_, file);
      if (!problem.empty()) add_problem(file.name + " " + problem);
    }
  }

  void check_manifest() {
    const nlohmann::json manifest =
        nlohmann::json::parse(read_file(folder_ / "manifest.json"), nullptr, false);
    try {
      check_.state = manifest.at("state");
      check_files(manifest.contains("files") ? files_of(manifest.at("files")) : std::vector<FileRecord>());
      if (!manifest.contains("files"))
        add_problem("manifest.json holds no hashes: an older inkbench wrote it");
    } catch (const nlohmann::json::exception&) {
      add_problem("manifest.json was changed");
    }
  }

  void check_journal() {
    for (const size_t line : journal_.damaged)
      add_problem(fmt::format("journal.jsonl, line {} is not what was written", line));
    if (journal_.older > 0)
      add_problem(
          fmt::format("journal.jsonl has {} lines without a hash, of an older inkbench", journal_.older));
    check_.cells = journal_.cells.size();
    for (const auto& [index, record] : journal_.cells) {
      check_files(record.files);
      check_files(record.overlays);
    }
  }

  /// Each row's numbers, which stand before its error, are those of the journal.
  void check_data() {
    const CsvTable table = parse_csv(read_file(folder_ / "data.csv"));
    const auto error = std::find(table.columns.begin(), table.columns.end(), "error");
    const auto end = static_cast<size_t>(error - table.columns.begin());
    std::set<size_t> found;
    for (const std::vector<std::string>& row : table.rows) {
      const auto record = journal_.cells.find(cell_of(row));
      if (record == journal_.cells.end()) continue;
      found.insert(record->first);
      if (end >= row.size() || !has_numbers(row, end, record->second))
        add_problem(fmt::format("data.csv, cell {}: the numbers are not those of the journal", row[0]));
    }
    for (const auto& [index, record] : journal_.cells) {
      if (!found.contains(index)) add_problem(fmt::format("data.csv has no row of cell {}", index + 1));
    }
  }

  /// Its index, as the first column says; one that no cell has where it says none.
  static size_t cell_of(const std::vector<std::string>& row) {
    size_t number = 0;
    if (!row.empty()) std::from_chars(row[0].data(), row[0].data() + row[0].size(), number);
    return number - 1;
  }

  static bool has_numbers(const std::vector<std::string>& row, size_t end, const CellRecord& record) {
    return record.numbers.size() <= end &&
           std::equal(record.numbers.begin(), record.numbers.end(),
                      row.begin() + static_cast<std::ptrdiff_t>(end - record.numbers.size()));
  }

  fs::path folder_;
  Journal journal_;
  StudyCheck check_;
  std::set<std::string> seen_;
};

}  // namespace

StudyCheck verify_study(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw input_error(folder.string(), "is no folder", "a study's is needed");
  if (!fs::exists(folder / "manifest.json", error)) {
    throw input_error(folder.string(), "holds no study: manifest.json is missing",
                      "give the folder that `inkbench study --out` wrote");
  }
  return Verification(folder).run();
}

}  // namespace inkbench
