// SPDX-License-Identifier: MIT
// A study's folder as the window shows it: where each cell stands in the grid, its pictures and numbers. In:
// a folder that `inkbench study` wrote or is writing. Out: what of it is there.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studies/report/grid.h"
#include "studies/sweep/spec.h"
#include "studies/sweep/study_charts.h"

namespace inkbench {

/// What a study's folder says of itself, without its cells.
struct StudySummary {
  std::string title;
  std::string state;  ///< "running", "stopped" or "finished"; "running" of a run that was killed, too.
  size_t cells = 0;
};

/// Errors (input): no manifest.json, or not one of ours.
StudySummary read_summary(const std::filesystem::path& folder);

class StudyResults {
 public:
  /// `spec`: the file that was run, from where its relative paths start; where it is empty or gone, the
  /// manifest's spec is read as if it lay beside the folder, or with the bundled ones. Errors (input): no
  /// study in the folder, or its spec cannot be read any more.
  StudyResults(const std::filesystem::path& folder, const std::filesystem::path& spec);

  /// Takes in cells that ended since. Returns whether there were any.
  bool refresh();
  /// Whether the folder held another spec's study at the last `refresh`: this is out of date as a whole.
  bool is_replaced() const { return replaced_; }

  const std::filesystem::path& folder() const { return folder_; }
  const StudySpec& spec() const { return spec_; }
  const StudySummary& summary() const { return summary_; }

  const GridAxis& columns() const { return columns_; }
  const GridAxis& rows() const { return rows_; }
  const GridAxis& pages() const { return pages_; }
  size_t cell_at(size_t column, size_t row, size_t page) const {
    return (page * rows_.values.size() + row) * columns_.values.size() + column;
  }

  /// The spec's charts, once the study is finished: only then they are drawn.
  std::vector<DrawnChart> charts() const;
  /// What the folder took on the disk when the study finished; 0 before.
  uintmax_t bytes() const { return bytes_; }

  size_t done() const { return rows_of_data_.size() - failed_; }
  size_t failed() const { return failed_; }
  bool has(size_t cell) const { return rows_of_data_.contains(cell); }
  /// Why the cell failed; "" where it did not.
  const std::string& error(size_t cell) const;

  /// "final", or with views "front_final": what each cell has.
  const std::vector<std::string>& pictures() const { return pictures_; }
  /// A cell's file; empty while it is not there.
  std::filesystem::path picture(size_t cell, size_t picture) const;

  /// The size at which a cell's picture is drawn.
  ImageParams image(size_t cell, size_t picture) const;

  /// "ink", "f1", ...
  const std::vector<std::string>& numbers() const { return numbers_; }
  /// A cell's number as data.csv has it; "" where there is none.
  const std::string& number(size_t cell, size_t number) const;

 private:
  const std::string& field(size_t cell, const std::string& column) const;
  bool read_data();
  void take_row(std::vector<std::string> row);
  void forget_data();
  void weigh();

  std::filesystem::path folder_;
  StudySummary summary_;
  std::string spec_text_;
  bool replaced_ = false;
  StudySpec spec_;
  GridAxis columns_, rows_, pages_;
  std::vector<std::string> pictures_, numbers_;
  std::map<std::string, size_t> header_;
  std::map<size_t, std::vector<std::string>> rows_of_data_;
  size_t failed_ = 0;
  uintmax_t bytes_ = 0;
  ino_t data_file_ = 0;
  uintmax_t data_read_ = 0;  ///< Bytes taken in; a file that is written anew is another one.
};

}  // namespace inkbench
