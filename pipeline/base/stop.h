// SPDX-License-Identifier: MIT
// Long work that can be given up. In: a question that it asks now and then. Out: an exception once the answer
// is yes.
#pragma once

#include <exception>
#include <functional>

namespace inkbench {

/// May be empty, which never stops.
using StopAsked = std::function<bool()>;

/// Thrown by work that was asked to stop.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

}  // namespace inkbench
