// SPDX-License-Identifier: MIT
// What the command line's tests share: a temporary folder for each test, `inkbench` run in it, and what a
// success, a bad input and a failed piece of work look like from outside.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/cli/command.h"

namespace inkbench {

namespace fs = std::filesystem;

/// The name of each regular file below a folder, relative to it, with its content.
using FolderContent = std::map<std::string, std::string>;

class CliTest : public testing::Test {
 protected:
  CliTest();
  ~CliTest() override;

  /// Runs `inkbench ARGUMENTS` in the test's folder (or the options' one).
  CommandResult inkbench(const std::vector<std::string>& arguments, CommandOptions options = {}) const;

  fs::path file(const std::string& name) const { return folder_ / name; }
  /// Writes a file of that name in the test's folder; returns its path.
  fs::path write(const std::string& name, const std::string& content) const;

 private:
  fs::path folder_;
};

std::string content_of(const fs::path& path);
FolderContent folder_content(const fs::path& folder);

/// The names of files that a failed or killed writer may leave ("x.png.part12-0") below the folder.
std::vector<std::string> unfinished_files(const fs::path& folder);

/// Exit status 0 and no error line.
testing::AssertionResult succeeds(const CommandResult& result);

/// Exit status 2 with one plain line on stderr that holds each of the words; nothing else there but notes.
testing::AssertionResult is_input_error(const CommandResult& result, const std::vector<std::string>& words);

/// The same with exit status 1.
testing::AssertionResult is_work_error(const CommandResult& result, const std::vector<std::string>& words);

/// A scene without the rabbit, quick to draw and the same in no direction: a turned box to the lower left, a
/// ball to the upper right, in front of a plane that the camera sees under an angle. 64 x 48 px.
std::string small_scene();

}  // namespace inkbench
