// What a study has finished, one line a cell, appended as cells end. It decides what a later run trusts: a
// cell counts only if its key and the size and hash of each of its files are still those of its line.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/base/key.h"

namespace inkbench {

struct FileRecord {
  std::string name;  ///< Relative to the study's folder.
  uint64_t bytes = 0;
  std::string hash;
};

struct CellRecord {
  size_t index = 0;
  std::string key;                   ///< Of all that decided the cell.
  std::vector<std::string> numbers;  ///< As they stand in data.csv.
  std::vector<FileRecord> files;
};

/// The record of a file as it lies on the disk. Errors (input): it cannot be read.
FileRecord record_file(const std::filesystem::path& folder, const std::string& name);

std::string journal_line(const CellRecord& record);

/// All whole lines of a journal; a torn last line or a damaged one is left out. Empty where there is no
/// journal.
std::map<size_t, CellRecord> read_journal(const std::filesystem::path& path);

/// Whether the record's files are all there, unchanged.
bool files_intact(const std::filesystem::path& folder, const CellRecord& record);

}  // namespace inkbench
