// SPDX-License-Identifier: MIT
// Long work that can be given up. In: a question that it asks now and then, or a signal to the whole process.
// Out: an exception once the answer is yes.
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

/// Asks all work of this process to stop. May be called in a signal's handler.
void ask_to_stop() noexcept;
bool stop_asked() noexcept;

/// Throws `Stopped` once the process was asked to stop, or `stop` says so. Cheap enough for inner loops where
/// `stop` is.
void stop_if_asked(const StopAsked& stop = {});

}  // namespace inkbench
