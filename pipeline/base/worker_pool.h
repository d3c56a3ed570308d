// SPDX-License-Identifier: MIT
// Threads that take work from a bounded queue: encoding fills the time that drawing leaves, and memory does
// not grow when encoding is the slower one.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace inkbench {

/// Whether its threads let others go first, such as the one that draws.
enum class WorkerPriority { behind_drawing, own };

class WorkerPool {
 public:
  WorkerPool(size_t threads, size_t queue_limit, WorkerPriority priority = WorkerPriority::behind_drawing);
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  /// Waits for all work.
  ~WorkerPool();

  /// Waits while the queue is full.
  void add(std::function<void()> work);
  /// Returns when all work added so far has ended. Throws what the first work that failed threw.
  void wait();

 private:
  void serve(WorkerPriority priority);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> queue_;
  size_t queue_limit_;
  size_t busy_ = 0;
  bool closing_ = false;
  std::exception_ptr thrown_;
  std::vector<std::thread> threads_;
};

}  // namespace inkbench
