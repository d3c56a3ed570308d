// SPDX-License-Identifier: MIT
#include "pipeline/base/stop.h"

#include <atomic>

namespace inkbench {
namespace {

std::atomic<bool> g_stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal's handler sets it");

}  // namespace

void ask_to_stop() noexcept {
  g_stop_asked.store(true, std::memory_order_relaxed);
}

bool stop_asked() noexcept {
  return g_stop_asked.load(std::memory_order_relaxed);
}

void stop_if_asked(const StopAsked& stop) {
  if (stop_asked() || (stop && stop())) throw Stopped();
}

}  // namespace inkbench
