// SPDX-License-Identifier: MIT
#include "tests/app/display.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace inkbench {
namespace {

constexpr int kStartMilliseconds = 20000;

/// Ends with the tests, however they end.
[[noreturn]] void become(const std::vector<std::string>& command) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

/// What the server writes when it is ready: its display's number.
std::string read_number(int descriptor) {
  std::string text;
  pollfd wait{descriptor, POLLIN, 0};
  while (text.find('\n') == std::string::npos && poll(&wait, 1, kStartMilliseconds) > 0) {
    std::array<char, 16> block{};
    const ssize_t count = read(descriptor, block.data(), block.size());
    if (count <= 0) break;
    text.append(block.data(), static_cast<size_t>(count));
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

Display::Display() {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    become(
        {"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "1920x1080x24", "-nolisten", "tcp"});
  }
  close(ends[1]);
  name_ = ":" + read_number(ends[0]);
  close(ends[0]);
  if (name_ == ":") throw std::runtime_error("Xvfb did not start; install Debian's package xvfb");
}

Display::~Display() {
  if (process_ <= 0) return;
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
}

pid_t start_program(const std::vector<std::string>& command,
                    const std::map<std::string, std::string>& environment, const std::string& folder,
                    const std::string& log) {
  const pid_t process = fork();
  if (process != 0) return process;
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  if (chdir(folder.c_str()) != 0) _exit(126);
  become(command);
}

}  // namespace inkbench
