// SPDX-License-Identifier: MIT
// What a study has finished, one line a cell, appended as cells end. It decides what a later run trusts:
// pictures and numbers count only if their line bears the hash of itself, their key is still that of the
// line, and the size and hash of each file are.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/base/key.h"
#include "studies/sweep/file_record.h"
#include "studies/sweep/result_origin.h"

namespace inkbench {

struct CellRecord {
  size_t index = 0;
  std::string key;                   ///< Of all that decided the pictures.
  std::string numbers_key;           ///< And the numbers.
  ResultOrigin origin;               ///< Parts of both keys: for saying why they are others now.
  std::vector<std::string> numbers;  ///< As they stand in data.csv.
  std::vector<FileRecord> files;     ///< The pictures.
  std::vector<FileRecord> overlays;  ///< The reference lines of each view, where they were found.
};

struct Journal {
  std::map<size_t, CellRecord> cells;  ///< Of two lines of a cell the later counts.
  std::vector<size_t> damaged;         ///< The numbers, from 1, of lines that are not what was written.
  size_t older = 0;                    ///< Lines of an inkbench that wrote no hash: they do not count.
};

/// With its hash as the last entry, and its end.
std::string journal_line(const CellRecord& record);

/// A last line without its end was torn by a kill: it does not count, and is no damage. Empty where there is
/// no journal.
Journal read_journal(const std::filesystem::path& path);

}  // namespace inkbench
