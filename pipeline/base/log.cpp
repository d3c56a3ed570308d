// SPDX-License-Identifier: MIT
#include "pipeline/base/log.h"

#include <cstdio>
#include <mutex>
#include <utility>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

std::mutex& log_mutex() {
  static std::mutex mutex;
  return mutex;
}

LogSink& log_sink() {
  static LogSink sink;
  return sink;
}

}  // namespace

void log_note(const std::string& text) {
  const std::lock_guard lock(log_mutex());
  if (log_sink()) {
    log_sink()(text);
  } else {
    std::fprintf(stderr, "inkbench: note: %s\n", printable(text).c_str());
  }
}

LogSink set_log_sink(LogSink sink) {
  const std::lock_guard lock(log_mutex());
  return std::exchange(log_sink(), std::move(sink));
}

}  // namespace inkbench
