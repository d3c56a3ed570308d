// SPDX-License-Identifier: MIT
#include "app/window/end_signals.h"

#include <csignal>

namespace inkbench {
namespace {

volatile std::sig_atomic_t g_end_is_asked = 0;

void ask_for_end(int /*signal*/) {
  g_end_is_asked = 1;
}

}  // namespace

void watch_end_signals() {
  struct sigaction action {};
  action.sa_handler = ask_for_end;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    struct sigaction before {};
    // One that is ignored stays so: the shell's nohup asked for it.
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    sigaction(signal, &action, nullptr);
  }
}

bool end_is_asked() {
  return g_end_is_asked != 0;
}

}  // namespace inkbench
