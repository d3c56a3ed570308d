// SPDX-License-Identifier: MIT
#include "pipeline/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace inkbench {
namespace {

/// Turns that a thread takes at once: few enough that none waits long for the last one.
constexpr size_t kAtOnce = 16;

/// One call's turns. Who comes late finds none left, so nobody waits for a thread that has not begun.
class Loop {
 public:
  Loop(size_t count, const std::function<void(size_t)>& turn) : count_(count), turn_(turn) {}

  void work() {
    for (size_t first = next_.fetch_add(kAtOnce); first < count_; first = next_.fetch_add(kAtOnce)) {
      const size_t last = std::min(first + kAtOnce, count_);
      try {
        for (size_t i = first; i < last && !failed_; ++i) turn_(i);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        failed_ = true;
        thrown_ = std::current_exception();
      }
      const std::lock_guard lock(mutex_);
      done_ += last - first;
      if (done_ == count_) all_done_.notify_all();
    }
  }

  void wait() {
    std::unique_lock lock(mutex_);
    all_done_.wait(lock, [&] { return done_ == count_; });
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const size_t count_;
  const std::function<void(size_t)>& turn_;  ///< Not called once all turns are taken.
  std::atomic<size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::condition_variable all_done_;
  size_t done_ = 0;
  std::exception_ptr thrown_;
};

/// Threads beside the callers', one fewer than processors, for as long as the program runs.
class Helpers {
 public:
  Helpers() {
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    for (unsigned i = 1; i < processors; ++i) threads_.emplace_back([this] { serve(); });
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;
  ~Helpers() {
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
    }
    added_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void offer(const std::shared_ptr<Loop>& loop) {
    if (threads_.empty()) return;
    {
      const std::lock_guard lock(mutex_);
      for (size_t i = 0; i < threads_.size(); ++i) loops_.push_back(loop);
    }
    added_.notify_all();
  }

 private:
  void serve() {
    for (;;) {
      std::shared_ptr<Loop> loop;
      {
        std::unique_lock lock(mutex_);
        added_.wait(lock, [&] { return closing_ || !loops_.empty(); });
        if (closing_) return;
        loop = std::move(loops_.front());
        loops_.pop_front();
      }
      loop->work();
    }
  }

  std::mutex mutex_;
  std::condition_variable added_;
  std::deque<std::shared_ptr<Loop>> loops_;
  bool closing_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace

void for_each_in_parallel(size_t count, const std::function<void(size_t)>& turn) {
  if (count == 0) return;
  const auto loop = std::make_shared<Loop>(count, turn);
  if (count > kAtOnce) {
    static Helpers helpers;
    helpers.offer(loop);
  }
  loop->work();
  loop->wait();
}

}  // namespace inkbench
