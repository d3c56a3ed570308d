// SPDX-License-Identifier: MIT
// What a study has finished, one line a cell, appended as cells end. It decides what a later run trusts:
// pictures and numbers count only if their key is still that of its line, and the size and hash of each file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/base/key.h"
#include "studies/sweep/result_origin.h"

namespace inkbench {

struct FileRecord {
  std::string name;  ///< Relative to the study's folder.
  uint64_t bytes = 0;
  std::string hash;
};

struct CellRecord {
  size_t index = 0;
  std::string key;                   ///< Of all that decided the pictures.
  std::string numbers_key;           ///< And the numbers.
  ResultOrigin origin;               ///< Parts of both keys: for saying why they are others now.
  std::vector<std::string> numbers;  ///< As they stand in data.csv.
  std::vector<FileRecord> files;     ///< The pictures.
  std::vector<FileRecord> overlays;  ///< The reference lines of each view, where they were found.
};

/// The record of a file as it lies on the disk. Errors (input): it cannot be read.
FileRecord record_file(const std::filesystem::path& folder, const std::string& name);

std::string journal_line(const CellRecord& record);

/// All whole lines of a journal; a torn last line or a damaged one is left out. A line of an older inkbench
/// has no origin and no key of numbers. Empty where there is no journal.
std::map<size_t, CellRecord> read_journal(const std::filesystem::path& path);

/// Whether the files are all there, unchanged.
bool files_intact(const std::filesystem::path& folder, const std::vector<FileRecord>& files);

}  // namespace inkbench
