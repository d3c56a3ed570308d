// SPDX-License-Identifier: MIT
#include "app/hear_signals.h"

#include <semaphore.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "app/terminal.h"
#include "pipeline/base/forced_end.h"
#include "pipeline/base/stop.h"

namespace inkbench {
namespace {

/// For the work to stop in its own way. A pass of the software renderer cannot be left, and may take longer.
constexpr std::chrono::milliseconds kGrace{700};

sem_t g_asked;

void handle(int /*signal*/) {
  const int saved = errno;
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
  ask_to_stop();
  sem_post(&g_asked);
  errno = saved;
}

/// Nothing that is ended in the middle is lost or left half-written: files take their names when they are
/// whole.
[[noreturn]] void end_what_does_not_stop() {
  while (sem_wait(&g_asked) != 0) {
  }
  std::this_thread::sleep_for(kGrace);
  do_forced_end_actions();
  _exit(fail("stopped before the work was done", 1));
}

}  // namespace

void hear_signals() {
  sem_init(&g_asked, 0, 0);
  std::thread(end_what_does_not_stop).detach();
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction previous {};
    sigaction(number, nullptr, &previous);
    if (previous.sa_handler != SIG_IGN) std::signal(number, handle);  // nohup, or a shell's background job
  }
}

}  // namespace inkbench
