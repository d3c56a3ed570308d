// SPDX-License-Identifier: MIT
// What the window tells a person: messages, which go to the log, and problems, which also stand in the way
// until they are mended or dismissed. In: texts. Out: the problems as they are now.
#pragma once

#include <map>
#include <string>

#include "app/workbench/message_log.h"

namespace inkbench {

/// What stands in the way, by where it comes from.
enum class ProblemKind { drawing, shader, input };

class Problems {
 public:
  /// `log` must outlive it.
  explicit Problems(MessageLog& log) : log_(log) {}

  void tell(Severity severity, const std::string& text) { log_.add(severity, text); }
  /// Takes the place of the kind's last one; the same again is not told again.
  void set(ProblemKind kind, const std::string& text);
  void dismiss(ProblemKind kind) { problems_.erase(kind); }
  const std::map<ProblemKind, std::string>& all() const { return problems_; }

 private:
  MessageLog& log_;
  std::map<ProblemKind, std::string> problems_;
};

}  // namespace inkbench
