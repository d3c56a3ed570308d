// SPDX-License-Identifier: MIT
// Notes that do not stop the work: what a mesh loader dropped, which fallback was taken. They go to stderr as
// `inkbench: note: ...` unless a sink (a window's log, a test) is set.
#pragma once

#include <functional>
#include <string>

namespace inkbench {

using LogSink = std::function<void(const std::string&)>;

/// Writes one note, without a newline at its end. Safe from any thread.
void log_note(const std::string& text);

/// Sends every later note to `sink`; an empty one restores stderr. Returns the sink that was set before.
LogSink set_log_sink(LogSink sink);

}  // namespace inkbench
