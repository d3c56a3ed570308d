// SPDX-License-Identifier: MIT
// The child process in which foreign readers run: whatever happens there is an answer here.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "pipeline/mesh/formats/isolated_call.h"

namespace inkbench {
namespace {

using namespace std::chrono_literals;

TEST(IsolatedCall, bytes_come_back_whole_and_in_order) {
  std::vector<uint8_t> large(3'000'001);
  for (size_t i = 0; i < large.size(); ++i) large[i] = static_cast<uint8_t>(i * 31);
  const IsolatedResult result = call_isolated(
      [&](const ByteSink& sink) {
        sink(std::span(large).first(1));
        sink(std::span(large).subspan(1));
      },
      {});
  EXPECT_EQ(result.end, IsolatedEnd::returned);
  EXPECT_EQ(result.bytes, large);
}

TEST(IsolatedCall, the_child_changes_nothing_here_and_prints_nothing) {
  int value = 1;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  call_isolated(
      [&](const ByteSink&) {
        value = 2;
        std::cout << "noise" << std::endl;
        std::cerr << "noise" << std::endl;
      },
      {});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(value, 1);
}

TEST(IsolatedCall, an_exception_arrives_as_text) {
  const IsolatedResult result =
      call_isolated([](const ByteSink&) { throw std::runtime_error("what it was"); }, {});
  EXPECT_EQ(result.end, IsolatedEnd::threw);
  EXPECT_EQ(result.text(), "what it was");
}

TEST(IsolatedCall, crashes_and_early_exits_are_told_apart_from_success) {
  for (const int number : {SIGSEGV, SIGABRT, SIGKILL}) {
    EXPECT_EQ(call_isolated([=](const ByteSink&) { raise(number); }, {}).end, IsolatedEnd::crashed) << number;
  }
  EXPECT_EQ(call_isolated([](const ByteSink&) { _exit(1); }, {}).end, IsolatedEnd::crashed);
}

TEST(IsolatedCall, an_endless_loop_ends_with_its_time) {
  const IsolatedResult result = call_isolated(
      [](const ByteSink&) {
        while (true) pause();
      },
      {.time = 200ms});
  EXPECT_EQ(result.end, IsolatedEnd::timed_out);
}

TEST(IsolatedCall, endless_output_ends_with_its_time) {
  const IsolatedResult result = call_isolated(
      [](const ByteSink& sink) {
        const std::vector<uint8_t> block(64);
        while (true) {
          sink(block);
          usleep(1000);
        }
      },
      {.time = 200ms});
  EXPECT_EQ(result.end, IsolatedEnd::timed_out);
}

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define INKBENCH_ADDRESS_SANITIZER 1
#endif
#endif
#if !defined(__SANITIZE_ADDRESS__) && !defined(INKBENCH_ADDRESS_SANITIZER)
TEST(IsolatedCall, memory_beyond_the_limit_is_refused_to_the_child) {
  const auto allocate = [](const ByteSink& sink) {
    // More than earlier tests may have left free on this process's heap, which the child may use.
    const std::vector<uint8_t> block(size_t{256} << 20, 1);
    sink(std::span(block).last(1));
  };
  EXPECT_EQ(call_isolated(allocate, {.extra_memory_bytes = size_t{512} << 20}).end, IsolatedEnd::returned);
  EXPECT_EQ(call_isolated(allocate, {.extra_memory_bytes = size_t{16} << 20}).end,
            IsolatedEnd::out_of_memory);
}
#endif

}  // namespace
}  // namespace inkbench
