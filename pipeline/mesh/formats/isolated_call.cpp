// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/isolated_call.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <utility>

#include "pipeline/base/descriptor.h"
#include "pipeline/base/error.h"
#include "pipeline/base/stop.h"

#if defined(__SANITIZE_ADDRESS__)
#define INKBENCH_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define INKBENCH_ADDRESS_SANITIZER 1
#endif
#endif

namespace inkbench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kThrewStatus = 3;
constexpr int kOutOfMemoryStatus = 4;

void limit_resource(__rlimit_resource resource, size_t value) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, value);
  setrlimit(resource, &limit);
}

#ifdef INKBENCH_ADDRESS_SANITIZER
void limit_memory(size_t) {}
#else
size_t address_space_bytes() {
  std::FILE* file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) return 0;
  unsigned long pages = 0;
  const int fields = std::fscanf(file, "%lu", &pages);
  std::fclose(file);
  return fields == 1 ? pages * static_cast<size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void limit_memory(size_t extra_bytes) {
  const size_t used = address_space_bytes();
  if (used > 0) limit_resource(RLIMIT_AS, used + extra_bytes);
}
#endif

/// A crash in the child is an answer, not an event: no handler of ours, no core file, no text on the
/// terminal.
void make_quiet() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGPIPE}) {
    std::signal(number, SIG_DFL);
  }
  limit_resource(RLIMIT_CORE, 0);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

void write_all(int descriptor, std::span<const uint8_t> data) {
  while (!data.empty()) {
    const ssize_t written = write(descriptor, data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) _exit(kThrewStatus);  // the parent stopped listening
    data = data.subspan(static_cast<size_t>(written));
  }
}

[[noreturn]] void run_child(const std::function<void(const ByteSink&)>& work, const IsolationLimits& limits,
                            int output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  make_quiet();
  limit_memory(limits.extra_memory_bytes);
  try {
    work([output](std::span<const uint8_t> data) { write_all(output, data); });
  } catch (const std::bad_alloc&) {
    _exit(kOutOfMemoryStatus);
  } catch (const std::exception& exception) {
    const char* text = exception.what();
    write_all(output, {reinterpret_cast<const uint8_t*>(text), std::strlen(text)});
    _exit(kThrewStatus);
  } catch (...) {
    _exit(kThrewStatus);
  }
  _exit(0);  // no destructors: the open files and GL contexts belong to the parent
}

constexpr std::chrono::milliseconds kMostWait{100};  ///< Until it is asked again whether to stop.

/// Reads until the child closes its end; false when the time is over. Throws `Stopped` where the process was
/// asked to stop.
bool read_until_closed(int input, Clock::time_point deadline, std::vector<uint8_t>& bytes) {
  std::vector<uint8_t> block(size_t{1} << 16);
  while (true) {
    stop_if_asked();
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return false;
    pollfd waiting{input, POLLIN, 0};
    const int ready = poll(&waiting, 1, static_cast<int>(std::min(left, kMostWait).count()));
    if (ready <= 0) continue;
    const ssize_t count = read(input, block.data(), block.size());
    if (count == 0) return true;
    if (count > 0) bytes.insert(bytes.end(), block.begin(), block.begin() + count);
  }
}

IsolatedEnd wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return IsolatedEnd::crashed;
  }
  if (!WIFEXITED(status)) return IsolatedEnd::crashed;
  switch (WEXITSTATUS(status)) {
    case 0:
      return IsolatedEnd::returned;
    case kThrewStatus:
      return IsolatedEnd::threw;
    case kOutOfMemoryStatus:
      return IsolatedEnd::out_of_memory;
    default:
      return IsolatedEnd::crashed;
  }
}

/// The child: ended and waited for on every way out.
class Child {
 public:
  explicit Child(pid_t process) : process_(process) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    wait_for(process_);
  }
  IsolatedEnd wait() { return wait_for(std::exchange(process_, 0)); }

 private:
  pid_t process_;
};

}  // namespace

IsolatedResult call_isolated(const std::function<void(const ByteSink&)>& work,
                             const IsolationLimits& limits) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw work_error("", "no pipe can be made", std::strerror(errno));
  Descriptor input(ends[0]);
  Descriptor output(ends[1]);
  const pid_t process = fork();
  if (process < 0) throw work_error("", "no process can be started", std::strerror(errno));
  if (process == 0) run_child(work, limits, output.number());

  Child child(process);
  output.reset();
  IsolatedResult result;
  if (!read_until_closed(input.number(), Clock::now() + limits.time, result.bytes)) {
    return {IsolatedEnd::timed_out, {}};
  }
  result.end = child.wait();
  stop_if_asked();  // a terminal's Ctrl-C ends the child, too: no crash of its own
  return result;
}

}  // namespace inkbench
