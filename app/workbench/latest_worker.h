// SPDX-License-Identifier: MIT
// Work beside the window, for the newest request: what waits is replaced. In: requests, as values. Out:
// results, one at a time; the window never waits for one.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "pipeline/base/priority.h"
#include "pipeline/base/stop.h"

namespace inkbench {

/// What becomes of the request in work when a newer one comes.
enum class WhenNewer { finish, give_up };

/// `below`: what follows a slider lets the window go first where processors are few.
enum class WorkPriority { as_window, below };

template <class Request, class Result>
class LatestWorker {
 public:
  /// Runs on the worker's thread. It may throw nothing but `Stopped`, and should soon after it is asked to
  /// stop.
  using Work = std::function<Result(const Request&, const StopAsked&)>;

  /// `on_done` is called on the worker's thread after each result: to wake a window that sleeps.
  LatestWorker(Work work, WhenNewer when_newer, WorkPriority priority, std::function<void()> on_done)
      : work_(std::move(work)),
        gives_up_(when_newer == WhenNewer::give_up),
        on_done_(std::move(on_done)),
        thread_([this, priority] {
          if (priority == WorkPriority::below) step_back_for_drawing();
          serve();
        }) {}
  LatestWorker(const LatestWorker&) = delete;
  LatestWorker& operator=(const LatestWorker&) = delete;
  /// Forgets what waits and waits only for the work to stop.
  ~LatestWorker() {
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
      waiting_.reset();
    }
    changed_.notify_all();
    thread_.join();
  }

  /// Replaces a request that still waits.
  void submit(Request request) {
    {
      const std::lock_guard lock(mutex_);
      waiting_ = std::move(request);
    }
    changed_.notify_all();
  }

  /// The newest result, once; nothing where there is no new one.
  std::optional<Result> poll() {
    const std::lock_guard lock(mutex_);
    return std::exchange(result_, std::nullopt);
  }

  /// Whether a request waits or is in work.
  bool is_busy() const {
    const std::lock_guard lock(mutex_);
    return working_ || waiting_.has_value();
  }

 private:
  bool is_unwanted() const {
    const std::lock_guard lock(mutex_);
    return closing_ || (gives_up_ && waiting_.has_value());
  }

  std::optional<Result> work_on(const Request& request) const {
    try {
      return work_(request, [this] { return is_unwanted(); });
    } catch (const Stopped&) {
      return std::nullopt;
    }
  }

  void serve() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return waiting_.has_value() || closing_; });
      if (closing_) return;
      const Request request = *std::exchange(waiting_, std::nullopt);
      working_ = true;
      lock.unlock();
      std::optional<Result> result = work_on(request);
      lock.lock();
      working_ = false;
      if (closing_) return;
      if (!result) continue;
      result_ = std::move(result);
      lock.unlock();
      if (on_done_) on_done_();
      lock.lock();
    }
  }

  Work work_;
  bool gives_up_;
  std::function<void()> on_done_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Request> waiting_;
  std::optional<Result> result_;
  bool working_ = false;
  bool closing_ = false;
  std::thread thread_;  ///< Last, so that it starts when all else is there.
};

}  // namespace inkbench
