// SPDX-License-Identifier: MIT
// What unit tests share: a folder that disappears with the test, and the text of an expected error.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "pipeline/base/error.h"
#include "pipeline/base/scratch_folder.h"

namespace inkbench {

/// An empty folder of its own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {}  // not defaulted: fixtures have const ones

  const std::filesystem::path& path() const { return scratch_.path(); }

  /// Writes a file, not atomically, so that tests of writing do not rest on what they test.
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path() / name).parent_path());
    std::ofstream(path() / name, std::ios::binary) << content;
    return path() / name;
  }

 private:
  ScratchFolder scratch_;
};

/// The message of the Error that `act` throws, of the kind `input` unless said otherwise; "" (and a failure)
/// without one.
template <class Act>
std::string error_of(const Act& act, ErrorKind kind = ErrorKind::input) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error was thrown";
  return "";
}

}  // namespace inkbench
