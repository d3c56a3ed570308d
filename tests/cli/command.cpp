// SPDX-License-Identifier: MIT
#include "tests/cli/command.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <system_error>

namespace inkbench {
namespace {

constexpr int kPollMilliseconds = 3;

struct Pipe {
  int read_end = -1, write_end = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  return {ends[0], ends[1]};
}

[[noreturn]] void become(const std::vector<std::string>& command, const CommandOptions& options, int out,
                         int err) {
  setpgid(0, 0);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  for (const auto& [name, value] : options.environment) setenv(name.c_str(), value.c_str(), 1);
  if (options.file_size_limit_bytes) {
    const rlimit limit{*options.file_size_limit_bytes, *options.file_size_limit_bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (!options.working_folder.empty() && chdir(options.working_folder.c_str()) != 0) _exit(126);
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(127);
}

/// Appends what is there to `text`; false at the end.
bool drain(int descriptor, std::string& text) {
  std::array<char, 65536> block;
  const ssize_t count = read(descriptor, block.data(), block.size());
  if (count > 0) text.append(block.data(), static_cast<size_t>(count));
  return count > 0;
}

/// Reads both pipes until they close, sending the signal and minding the time limit meanwhile.
void watch(pid_t process, Pipe& out, Pipe& err, const CommandOptions& options, CommandResult& result) {
  const auto start = std::chrono::steady_clock::now();
  bool signalled = false;
  std::array<pollfd, 2> waits{pollfd{out.read_end, POLLIN, 0}, pollfd{err.read_end, POLLIN, 0}};
  const std::array<std::string*, 2> texts{&result.out, &result.err};
  while (waits[0].fd >= 0 || waits[1].fd >= 0) {
    poll(waits.data(), waits.size(), kPollMilliseconds);
    for (size_t i = 0; i < waits.size(); ++i) {
      if (waits[i].fd >= 0 && waits[i].revents != 0 && !drain(waits[i].fd, *texts[i])) waits[i].fd = -1;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const int signal = !signalled && options.signal_when ? options.signal_when(seconds) : 0;
    if (signal != 0) signalled = kill(process, signal) == 0;
    if (seconds > options.time_limit_seconds && !result.timed_out)
      result.timed_out = kill(-process, SIGKILL) == 0;
  }
}

}  // namespace

CommandResult run_command(const std::vector<std::string>& command, const CommandOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Pipe out = make_pipe();
  Pipe err = make_pipe();
  const pid_t process = fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process == 0) become(command, options, out.write_end, err.write_end);
  setpgid(process, process);
  close(out.write_end);
  close(err.write_end);
  CommandResult result;
  watch(process, out, err, options, result);
  close(out.read_end);
  close(err.read_end);
  int status = 0;
  rusage usage{};
  wait4(process, &status, 0, &usage);
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  result.peak_memory_kb = usage.ru_maxrss;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace inkbench
