// SPDX-License-Identifier: MIT
#include "pipeline/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace inkbench {
namespace {

/// Turns that a thread takes at once: few enough that none waits long for the last one.
constexpr size_t kAtOnce = 16;

}  // namespace

void for_each_in_parallel(size_t count, const std::function<void(size_t)>& turn) {
  std::atomic<size_t> next{0};
  std::exception_ptr thrown;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (size_t first = next.fetch_add(kAtOnce); first < count; first = next.fetch_add(kAtOnce)) {
        for (size_t i = first; i < std::min(first + kAtOnce, count); ++i) turn(i);
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      thrown = std::current_exception();
    }
  };
  const size_t useful = (count + kAtOnce - 1) / kAtOnce;
  std::vector<std::thread> helpers;
  for (size_t i = 1; i < std::min<size_t>(std::max(1U, std::thread::hardware_concurrency()), useful); ++i)
    helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace inkbench
