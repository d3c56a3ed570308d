// SPDX-License-Identifier: MIT
// The pool: all work is done once, the queue stays short, waiting means waiting.
#include "pipeline/base/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

namespace inkbench {
namespace {

using namespace std::chrono_literals;

TEST(WorkerPool, all_work_is_done_once_whatever_the_threads) {
  for (const size_t threads : {1U, 2U, 8U, 32U}) {
    std::vector<std::atomic<int>> times(2000);
    WorkerPool pool(threads, 3);
    for (std::atomic<int>& count : times) pool.add([&] { ++count; });
    pool.wait();
    for (size_t i = 0; i < times.size(); ++i)
      ASSERT_EQ(times[i], 1) << "work " << i << " on " << threads << " threads";
  }
}

TEST(WorkerPool, wait_returns_only_when_the_last_work_has_ended) {
  std::atomic<bool> ended = false;
  WorkerPool pool(2, 2);
  pool.add([&] {
    std::this_thread::sleep_for(50ms);
    ended = true;
  });
  pool.wait();
  EXPECT_TRUE(ended);
}

TEST(WorkerPool, wait_without_work_returns) {
  WorkerPool pool(2, 2);
  pool.wait();
}

TEST(WorkerPool, takes_work_again_after_a_wait) {
  std::atomic<int> count = 0;
  WorkerPool pool(2, 2);
  pool.add([&] { ++count; });
  pool.wait();
  pool.add([&] { ++count; });
  pool.wait();
  EXPECT_EQ(count, 2);
}

TEST(WorkerPool, the_end_of_the_pool_waits_for_queued_work) {
  std::atomic<int> count = 0;
  {
    WorkerPool pool(1, 100);
    for (int i = 0; i < 50; ++i) {
      pool.add([&] {
        std::this_thread::sleep_for(1ms);
        ++count;
      });
    }
  }
  EXPECT_EQ(count, 50);
}

TEST(WorkerPool, adding_waits_while_the_queue_is_full) {
  std::promise<void> gate;
  const std::shared_future<void> open = gate.get_future().share();
  std::atomic<int> added = 0;
  WorkerPool pool(1, 2);
  std::thread adder([&] {
    for (int i = 0; i < 6; ++i) {
      pool.add([open] { open.wait(); });
      ++added;
    }
  });
  // One is being worked on and two are queued: the fourth has to wait.
  const auto deadline = std::chrono::steady_clock::now() + 5s;
  while (added < 3 && std::chrono::steady_clock::now() < deadline) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(50ms);
  const int added_before_the_gate_opened = added;
  gate.set_value();
  adder.join();
  pool.wait();
  EXPECT_EQ(added_before_the_gate_opened, 3);
  EXPECT_EQ(added, 6);
}

TEST(WorkerPool, threads_work_at_the_same_time) {
  std::promise<void> first;
  std::promise<void> second;
  WorkerPool pool(2, 2);
  std::atomic<int> met = 0;
  pool.add([&] {
    first.set_value();
    if (second.get_future().wait_for(5s) == std::future_status::ready) ++met;
  });
  pool.add([&] {
    second.set_value();
    if (first.get_future().wait_for(5s) == std::future_status::ready) ++met;
  });
  pool.wait();
  EXPECT_EQ(met, 2);
}

}  // namespace
}  // namespace inkbench
