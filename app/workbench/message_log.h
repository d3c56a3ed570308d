// SPDX-License-Identifier: MIT
// What the window tells: notes, warnings and errors with their time. Safe from any thread.
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace inkbench {

enum class Severity { note, warning, error };

struct Message {
  Severity severity = Severity::note;
  std::string time;  ///< "14:03:27", local.
  std::string text;
  int repeats = 1;  ///< The same message again is counted, not listed.
};

class MessageLog {
 public:
  /// `told` is called after every change, on the thread that made it.
  explicit MessageLog(std::function<void()> told = {}) : told_(std::move(told)) {}

  void add(Severity severity, const std::string& text);
  std::vector<Message> messages() const;
  void clear();
  /// Rises with every change: what is shown of it is out of date when this is another number.
  long revision() const;

 private:
  void put(Severity severity, const std::string& text);

  std::function<void()> told_;
  mutable std::mutex mutex_;
  std::deque<Message> messages_;
  long revision_ = 0;
};

}  // namespace inkbench
