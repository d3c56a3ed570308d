// SPDX-License-Identifier: MIT
// What the tests of `inkbench study` share: a small scene, specs over it, data.csv read back, folders
// compared.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/cli/cli_test.h"

namespace inkbench {

/// data.csv: columns in order, and a row for each cell by column's name.
struct StudyTable {
  std::vector<std::string> columns;
  std::vector<std::map<std::string, std::string>> rows;

  std::vector<std::string> column(const std::string& name) const;
};

class StudyTest : public CliTest {
 protected:
  StudyTest();

  /// Writes `name`.toml: a study of the small scene with `body` below its head.
  void write_spec(const std::string& name, const std::string& body) const;

  /// `inkbench study NAME.toml --out OUT ...`
  CommandResult study(const std::string& name, const std::string& out, std::vector<std::string> more = {},
                      const CommandOptions& options = {}) const;

  StudyTable table(const std::string& out) const;
};

/// An axis of `count` values that are not those of another count: 15 cells take about half a second.
std::string threshold_axis(int count);

/// The folder's files without what may differ between two runs: manifest.json's "times".
FolderContent lasting_content(const fs::path& folder);

/// "same", or the names of files that differ or are in one folder only.
std::string difference(const FolderContent& a, const FolderContent& b);

/// Sends a signal when that many of the study's pictures are on the disk.
CommandOptions signal_after(const fs::path& out, size_t pictures, int signal);

/// Checks that every file under its final name is whole: pictures decode and are those of the finished study
/// `expected`, the manifest parses, each line of data.csv and journal that is complete is one of the finished
/// study.
void expect_no_half_written_files(const fs::path& folder, const FolderContent& expected);

}  // namespace inkbench
