// SPDX-License-Identifier: MIT
#include "pipeline/base/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <thread>

#include "pipeline/base/error.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kMostOutput = 64 << 10;
constexpr std::chrono::milliseconds kPause{2};
constexpr std::chrono::milliseconds kMostWait{100};  ///< Until it is asked again whether to stop.

/// A program with its output in a pipe, in a process group of its own. It is killed where it still runs at
/// the end.
class Child {
 public:
  Child(const std::vector<std::string>& command, const std::string& hint) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw work_error("", "no pipe can be made", std::strerror(errno));
    output_ = ends[0];
    const int error = spawn(command, ends[1]);
    close(ends[1]);
    if (error == 0) return;
    close(output_);
    if (error == ENOENT) throw work_error(command.front(), "was not found", hint);
    throw work_error(command.front(), "cannot be started", std::strerror(error));
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    close(output_);
    if (process_ <= 0) return;
    kill(-process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  /// All that it writes until it closes its output; false where that took too long. Throws `Stopped`.
  bool read_all(Clock::time_point deadline, std::string& text) const {
    std::array<char, 4096> block;
    while (true) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
      pollfd wait{output_, POLLIN, 0};
      if (left <= 0) return false;
      const int ready = poll(&wait, 1, static_cast<int>(std::min<long long>(left, kMostWait.count())));
      stop_if_asked();
      if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
      if (ready < 0) return false;
      const ssize_t count = read(output_, block.data(), block.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return true;
      if (text.size() < kMostOutput) text.append(block.data(), static_cast<size_t>(count));
    }
  }

  /// The status as of waitpid, once it ends; nothing where that took too long.
  std::optional<int> wait(Clock::time_point deadline) {
    int status = 0;
    while (true) {
      const pid_t ended = waitpid(process_, &status, WNOHANG);
      if (ended == process_) {
        process_ = -1;
        return status;
      }
      if (ended < 0 && errno != EINTR)
        throw work_error("", "a process cannot be waited for", std::strerror(errno));
      if (Clock::now() > deadline) return std::nullopt;
      stop_if_asked();
      std::this_thread::sleep_for(kPause);
    }
  }

 private:
  int spawn(const std::vector<std::string>& command, int output) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const int error = posix_spawnp(&process_, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) process_ = -1;
    return error;
  }

  pid_t process_ = -1;
  int output_ = -1;
};

}  // namespace

ProgramEnd run_program(const std::vector<std::string>& command, std::chrono::milliseconds limit,
                       const std::string& hint) {
  Child child(command, hint);
  ProgramEnd end;
  const Clock::time_point deadline = Clock::now() + limit;
  const std::optional<int> status =
      child.read_all(deadline, end.output) ? child.wait(deadline) : std::nullopt;
  if (!status) {
    throw work_error("", command.front() + " did not end within " +
                             shortest(std::chrono::duration<double>(limit).count()) + " s");
  }
  end.status = WIFSIGNALED(*status) ? 128 + WTERMSIG(*status) : WEXITSTATUS(*status);
  return end;
}

}  // namespace inkbench
