// SPDX-License-Identifier: MIT
// Runs a function in a forked child process under limits on time and memory, and hands its bytes back. For
// code that may crash, hang or eat memory on bad input (OpenMesh's readers): the harm ends with the child.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace inkbench {

struct IsolationLimits {
  std::chrono::milliseconds time{10'000};
  size_t extra_memory_bytes = size_t{256} << 20;  ///< Address space beyond what this process uses now.
};

/// How the call ended. `threw`: `bytes` is the exception's text.
enum class IsolatedEnd { returned, threw, out_of_memory, crashed, timed_out };

struct IsolatedResult {
  IsolatedEnd end = IsolatedEnd::crashed;
  std::vector<uint8_t> bytes;

  std::string text() const { return {bytes.begin(), bytes.end()}; }
};

using ByteSink = std::function<void(std::span<const uint8_t>)>;

/// Calls `work(sink)` in the child and returns what it put into the sink. The child sees this process's
/// memory as it was, and changes nothing of it; its standard output and error go nowhere. The memory limit is
/// left out under AddressSanitizer, which needs terabytes of address space. Errors (work): no process or pipe
/// can be made.
IsolatedResult call_isolated(const std::function<void(const ByteSink&)>& work, const IsolationLimits& limits);

}  // namespace inkbench
