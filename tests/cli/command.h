// SPDX-License-Identifier: MIT
// Runs a program as a user would and keeps what it left: status, output, errors, peak memory. In: a command
// line and the conditions it runs under. Out: a CommandResult; a program that hangs is killed and says so.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace inkbench {

struct CommandOptions {
  std::filesystem::path working_folder;            ///< Empty: the tests' own.
  std::map<std::string, std::string> environment;  ///< On top of the tests' own.
  std::optional<uint64_t> file_size_limit_bytes;   ///< As a full disk: no file can grow past it.
  double time_limit_seconds = 60;
  /// Asked a few hundred times a second with the seconds since the start; a number other than 0 is sent as a
  /// signal, once.
  std::function<int(double)> signal_when;
};

struct CommandResult {
  int status = -1;  ///< Exit status; -1 where a signal ended it.
  int signal = 0;   ///< The signal that ended it, or 0.
  bool timed_out = false;
  std::string out, err;
  long peak_memory_kb = 0;  ///< Largest resident size of the process or one of its own children.
  double seconds = 0;
};

/// Standard input is empty; output and errors are pipes, not terminals. Throws std::system_error where no
/// process can be made.
CommandResult run_command(const std::vector<std::string>& command, const CommandOptions& options = {});

}  // namespace inkbench
