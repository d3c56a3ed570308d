// SPDX-License-Identifier: MIT
// Runs another program and waits for it: for those that do what no library does. In: a command. Out: how it
// ended and what it said.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace inkbench {

struct ProgramEnd {
  int status = 0;      ///< Its exit status, 128 and the signal's number where one ended it.
  std::string output;  ///< Of stdout and stderr together, at most 64 KiB.
};

/// Without an input, in a process group of its own, which is killed where it runs longer than `limit` or the
/// work is stopped. The first word is looked for in PATH. Errors (work): it is not found, with `hint` for how
/// to get it; it cannot be started; it did not end in time. Throws `Stopped`.
ProgramEnd run_program(const std::vector<std::string>& command, std::chrono::milliseconds limit,
                       const std::string& hint);

}  // namespace inkbench
