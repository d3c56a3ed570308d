// The panel of the history: every step by its name; a click goes to it.
#pragma once

#include <string>
#include <vector>

#include "app/window/workbench.h"

namespace inkbench {

class HistoryPanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  void draw_step(Workbench& bench, size_t position);

  std::vector<std::string> names_;
  long seen_revision_ = -1;
};

}  // namespace inkbench
