// SPDX-License-Identifier: MIT
// Work beside the window: asked for by name, once each; one flag says that something is there.
#include "app/workbench/background_work.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>

namespace inkbench {
namespace {

/// Doubles numbers; those below zero wait until `gate` opens.
class BackgroundWorkTest : public testing::Test {
 protected:
  using Doubler = BackgroundWork<int, int, std::string>;

  int doubled(int number) {
    if (number < 0) {
      begun_.set_value();
      gate_.get_future().wait();
    }
    return 2 * number;
  }
  void ask(const std::string& name, int number) {
    work_.ask(name, [&] {
      ++made_;
      return number;
    });
  }
  /// The next result; fails after half a minute.
  int wait_for_result() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < end) {
      if (const std::optional<int> result = work_.take()) return *result;
      std::this_thread::yield();
    }
    ADD_FAILURE() << "waited in vain";
    return 0;
  }

  std::promise<void> begun_, gate_;
  std::atomic<int> woken_ = 0;
  int made_ = 0;
  News news_{[this] {
    ++woken_;
    woken_.notify_all();
  }};
  Doubler work_{[this](int number, const StopAsked&) { return doubled(number); }, WhenNewer::finish,
                WorkPriority::as_window, news_};
};

TEST_F(BackgroundWorkTest, gives_the_result_once) {
  ask("three", 3);
  EXPECT_EQ(wait_for_result(), 6);
  EXPECT_FALSE(work_.take());
}

TEST_F(BackgroundWorkTest, the_same_name_is_not_asked_for_again) {
  ask("three", 3);
  EXPECT_EQ(wait_for_result(), 6);
  ask("three", 4);
  EXPECT_EQ(made_, 1);
  EXPECT_TRUE(work_.has_asked("three"));
}

TEST_F(BackgroundWorkTest, what_was_forgotten_is_asked_for_again) {
  ask("three", 3);
  EXPECT_EQ(wait_for_result(), 6);
  work_.forget();
  EXPECT_FALSE(work_.has_asked("three"));
  ask("three", 4);
  EXPECT_EQ(wait_for_result(), 8);
}

TEST_F(BackgroundWorkTest, when_free_makes_no_request_while_one_is_in_work) {
  ask("slow", -1);
  work_.ask_when_free("next", [&] {
    ++made_;
    return 2;
  });
  EXPECT_EQ(made_, 1);
  EXPECT_TRUE(work_.has_asked("slow"));
  gate_.set_value();
  EXPECT_EQ(wait_for_result(), -2);
}

TEST_F(BackgroundWorkTest, what_could_not_be_made_was_not_asked_for) {
  EXPECT_THROW(work_.ask("bad", []() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_FALSE(work_.has_asked("bad"));
  EXPECT_FALSE(work_.is_busy());
}

TEST_F(BackgroundWorkTest, is_busy_until_the_result_is_there) {
  EXPECT_FALSE(work_.is_busy());
  ask("slow", -1);
  begun_.get_future().wait();
  EXPECT_TRUE(work_.is_busy());
  gate_.set_value();
  EXPECT_EQ(wait_for_result(), -2);
  EXPECT_FALSE(work_.is_busy());
}

TEST_F(BackgroundWorkTest, a_result_is_news_once_and_wakes) {
  EXPECT_FALSE(news_.take());
  ask("three", 3);
  woken_.wait(0);
  EXPECT_TRUE(news_.take());
  EXPECT_FALSE(news_.take());
}

TEST_F(BackgroundWorkTest, when_news_are_told_the_result_can_be_taken) {
  ask("three", 3);
  woken_.wait(0);
  EXPECT_EQ(work_.take(), 6);
}

}  // namespace
}  // namespace inkbench
