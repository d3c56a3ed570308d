// SPDX-License-Identifier: MIT
// A program that runs beside us: started, listened to, told to stop, and never left behind. In: a command.
// Out: the lines that it writes and how it ended.
#pragma once

#include <sys/types.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace inkbench {

struct ChildOptions {
  bool yields = false;  ///< Runs only on time that nothing else wants.
};

class ChildProcess {
 public:
  /// Starts `command[0]`, a path, with an empty standard input. It is sent SIGINT when the thread that
  /// started it ends, however that ends. Errors (work): why it cannot be started.
  explicit ChildProcess(const std::vector<std::string>& command, const ChildOptions& options = {});
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Kills it where it still runs.
  ~ChildProcess();

  pid_t id() const { return process_; }
  void send(int signal) const;

  struct Lines {
    std::vector<std::string> out, err;
  };
  /// The whole lines written since the last call; at its end also a last one without an end. Does not wait.
  Lines take_lines();

  /// Whether it still runs; after that `exit_status` or `signal` says how it ended. Does not wait.
  bool is_running();
  /// Waits for its end, but no longer than this. Returns whether it ended.
  bool wait_for_end(double seconds);
  std::optional<int> exit_status() const;
  /// The signal that ended it, or 0.
  int signal() const;

 private:
  struct Stream {
    int descriptor = -1;
    std::string rest;  ///< A line without its end so far.
  };
  static void read_stream(Stream& stream, std::vector<std::string>& lines);

  pid_t process_ = -1;
  std::optional<int> status_;  ///< As waitpid gives it.
  std::array<Stream, 2> streams_;
};

/// Starts a program that goes on by itself, such as a file's viewer: it is found in PATH, and nobody waits
/// for it. Errors (work): it cannot be started.
void start_detached(const std::vector<std::string>& command);

}  // namespace inkbench
