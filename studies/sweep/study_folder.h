// SPDX-License-Identifier: MIT
// A study's folder: what an earlier run left that still counts, and the files that grow as cells end.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "studies/sweep/cell_keys.h"
#include "studies/sweep/journal.h"
#include "studies/sweep/spec.h"

namespace inkbench {

/// Keeps a second run out of a folder for as long as it lives; the system lifts it when a run is killed.
class FolderLock {
 public:
  /// Makes the folder. Errors (work): another run holds it, or it cannot be made.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int descriptor_;
};

/// What a cell still lacks.
enum class CellWork { none, measure, draw };

class StudyFolder {
 public:
  /// `keys[i]` are cell i's keys now, `origin` what this run makes results with. Reads the journal, drops
  /// every cell whose pictures' key or files are not what it says, with its files and what a killed run left
  /// unfinished, and starts journal and data.csv anew with the rest. A cell whose pictures are good and whose
  /// numbers are of another key lacks its numbers. Errors (work): the folder cannot be written.
  StudyFolder(const StudySpec& spec, std::filesystem::path folder, std::vector<CellKeys> keys,
              ResultOrigin origin, bool fresh);

  CellWork work(size_t index) const;
  bool is_done(size_t index) const { return work(index) == CellWork::none; }
  size_t done_count() const;

  /// What an earlier run left that is made again, and why: "3 cells are drawn again: ...".
  std::vector<std::string> notes() const;

  const std::filesystem::path& path() const { return folder_; }

  std::vector<size_t> done_cells() const;
  /// The files of a finished cell's pictures, view by view.
  std::vector<FileRecord> pictures(size_t index) const;

  /// "cells/0001_final.png", or with views "cells/0001_front_final.png"; relative to the folder.
  std::string cell_file(size_t index, size_t view, BufferName buffer) const;

  /// The cell's pictures, view by view.
  std::vector<std::string> picture_files(size_t index) const;

  /// The reference lines of a finished cell's view, relative to the folder: "reference/KEY.svg", which cells
  /// share where they are the same. "" where none were looked for.
  std::string overlay_file(size_t index, size_t view) const;
  /// The same of the picture of its causes, "causes/KEY.png".
  std::string cause_file(size_t index, size_t view) const;

  /// The counts of a cell's curve, "curves/0001.csv", whether they are there or not.
  std::string curve_file(size_t index) const;

  /// The columns of data.csv, and a finished or failed cell's fields; empty for any other.
  std::vector<std::string> columns() const;
  std::vector<std::string> fields(size_t index) const;

  /// Appends a finished cell to journal and data.csv, with a file of reference lines for each view, or none.
  /// All its files are on the disk already; of a cell that lacked its numbers the pictures stay as they are.
  /// Safe from any thread.
  void add(size_t index, std::vector<std::string> numbers, const std::vector<std::string>& overlays);
  void add_failure(size_t index, const std::string& message);

  /// Writes journal and data.csv once more in the grid's order, so that they do not tell in which order cells
  /// ended.
  void finish();

 private:
  /// "0001": with as many digits as the last cell's has, at least 4.
  std::string cell_number(size_t index) const;
  /// Sorts the records of an earlier run into `done_`, `unmeasured_` and those that are dropped.
  void take_journal(Journal&& journal);
  /// Why the pictures or the numbers do not count; "" where they do.
  std::string picture_problem(const CellRecord& record) const;
  std::string number_problem(const CellRecord& record) const;
  std::vector<std::string> row(size_t index, const std::vector<std::string>& numbers,
                               const std::string& error) const;
  std::string data_text() const;
  void remove_stale_files() const;
  void rewrite() const;
  /// Waits until the files, and what was written of them, are on the disk.
  void sync(const std::set<std::string>& files) const;

  const StudySpec& spec_;
  std::filesystem::path folder_;
  FolderLock lock_;
  std::vector<CellKeys> keys_;
  ResultOrigin origin_;
  std::vector<std::string> varied_;   ///< Keys that cells set, in order of first use.
  std::vector<std::string> numbers_;  ///< Their columns.
  std::map<size_t, CellRecord> done_;
  std::map<size_t, CellRecord> unmeasured_;    ///< Their pictures count.
  std::map<std::string, size_t> drawn_again_;  ///< Cells by the reason.
  std::map<std::string, size_t> measured_again_;
  std::map<size_t, std::string> failed_;
  std::set<std::string> unsynced_;  ///< Pictures and overlays that may not be on the disk yet.
  mutable std::mutex mutex_;
};

}  // namespace inkbench
