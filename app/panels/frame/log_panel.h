// The panel of the log: messages with their time, filtered, copied.
#pragma once

#include <string>

#include "app/window/workbench.h"

namespace inkbench {

class LogPanel {
 public:
  void draw(Workbench& bench);

 private:
  std::string filter_;
  bool only_errors_ = false;
  long seen_revision_ = 0;
};

}  // namespace inkbench
