// SPDX-License-Identifier: MIT
#include "app/workbench/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr int kYieldingNice = 15;

struct Pipe {
  int read_end = -1, write_end = -1;

  explicit Pipe(const std::string& program) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw work_error(program, std::string("cannot be started: ") + std::strerror(errno));
    read_end = ends[0];
    write_end = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(read_end);
    close_end(write_end);
  }
  static void close_end(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
};

std::vector<char*> arguments_of(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  return arguments;
}

/// Between fork and exec only calls that are safe with other threads' locks held.
void become_quiet(int out, int err) {
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(out >= 0 ? out : nothing, STDOUT_FILENO);
  dup2(err >= 0 ? err : nothing, STDERR_FILENO);
  close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
}

[[noreturn]] void report_failure(int pipe) {
  const int number = errno;
  [[maybe_unused]] const ssize_t written = write(pipe, &number, sizeof(number));
  _exit(127);
}

/// Waits until the program runs; throws where it does not.
void check_start(Pipe& failure, const std::string& program) {
  Pipe::close_end(failure.write_end);
  int number = 0;
  ssize_t count = 0;
  do {
    count = read(failure.read_end, &number, sizeof(number));
  } while (count < 0 && errno == EINTR);
  if (count == sizeof(number))
    throw work_error(program, std::string("cannot be started: ") + std::strerror(number));
}

pid_t forked(const std::string& program) {
  const pid_t process = fork();
  if (process < 0) throw work_error(program, std::string("cannot be started: ") + std::strerror(errno));
  return process;
}

void reap(pid_t process) {
  while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const ChildOptions& options) {
  Pipe out(command[0]), err(command[0]), failure(command[0]);
  std::vector<char*> arguments = arguments_of(command);
  const pid_t parent = getpid();
  process_ = forked(command[0]);
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGINT);
    if (getppid() != parent) _exit(127);  // it ended before we asked
    setpgid(0, 0);                        // Ctrl-C in a terminal reaches it through us alone
    if (options.yields) setpriority(PRIO_PROCESS, 0, kYieldingNice);
    become_quiet(out.write_end, err.write_end);
    execv(arguments[0], arguments.data());
    report_failure(failure.write_end);
  }
  try {
    check_start(failure, command[0]);
  } catch (const Error&) {
    reap(process_);
    throw;
  }
  streams_[0].descriptor = std::exchange(out.read_end, -1);
  streams_[1].descriptor = std::exchange(err.read_end, -1);
  for (const Stream& stream : streams_) fcntl(stream.descriptor, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  if (is_running()) {
    send(SIGKILL);
    reap(process_);
  }
  for (Stream& stream : streams_) Pipe::close_end(stream.descriptor);
}

void ChildProcess::send(int signal) const {
  if (!status_) kill(process_, signal);
}

void ChildProcess::read_stream(Stream& stream, std::vector<std::string>& lines) {
  std::array<char, 16384> block;
  while (stream.descriptor >= 0) {
    const ssize_t count = read(stream.descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) break;  // nothing there for now
    if (count == 0) Pipe::close_end(stream.descriptor);
    stream.rest.append(block.data(), static_cast<size_t>(count));
  }
  size_t start = 0;
  for (size_t end = 0; (end = stream.rest.find('\n', start)) != std::string::npos; start = end + 1)
    lines.push_back(stream.rest.substr(start, end - start));
  stream.rest.erase(0, start);
  if (stream.descriptor < 0 && !stream.rest.empty()) lines.push_back(std::exchange(stream.rest, {}));
}

ChildProcess::Lines ChildProcess::take_lines() {
  Lines lines;
  read_stream(streams_[0], lines.out);
  read_stream(streams_[1], lines.err);
  return lines;
}

bool ChildProcess::is_running() {
  if (status_) return false;
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) == process_) status_ = status;
  return !status_;
}

bool ChildProcess::wait_for_end(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (is_running()) {
    if (Clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

std::optional<int> ChildProcess::exit_status() const {
  if (status_ && WIFEXITED(*status_)) return WEXITSTATUS(*status_);
  return std::nullopt;
}

int ChildProcess::signal() const {
  return status_ && WIFSIGNALED(*status_) ? WTERMSIG(*status_) : 0;
}

void start_detached(const std::vector<std::string>& command) {
  Pipe failure(command[0]);
  std::vector<char*> arguments = arguments_of(command);
  const pid_t process = forked(command[0]);
  if (process == 0) {
    // A grandchild, so that the system and not we have to wait for its end.
    const pid_t viewer = fork();
    if (viewer < 0) report_failure(failure.write_end);
    if (viewer > 0) _exit(0);
    setsid();
    become_quiet(-1, -1);
    execvp(arguments[0], arguments.data());
    report_failure(failure.write_end);
  }
  reap(process);
  check_start(failure, command[0]);
}

}  // namespace inkbench
