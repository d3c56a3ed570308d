// SPDX-License-Identifier: MIT
// The panel of the log: messages with their time, filtered, copied.
#pragma once

#include <string>

#include "app/window/ui_map.h"
#include "app/workbench/message_log.h"

namespace inkbench {

class LogPanel {
 public:
  /// Both must outlive it.
  LogPanel(MessageLog& log, UiMap& ui_map) : log_(log), ui_map_(ui_map) {}

  void draw();

 private:
  MessageLog& log_;
  UiMap& ui_map_;
  std::string filter_;
  bool only_errors_ = false;
  long seen_revision_ = 0;
};

}  // namespace inkbench
