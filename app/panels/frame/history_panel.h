// SPDX-License-Identifier: MIT
// The panel of the history: every step by its name; a click goes to it.
#pragma once

#include <string>
#include <vector>

#include "app/window/ui_map.h"
#include "app/workbench/document.h"

namespace inkbench {

class HistoryPanel {
 public:
  /// Both must outlive it.
  HistoryPanel(Document& document, UiMap& ui_map) : document_(document), ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  void draw_step(size_t position);

  Document& document_;
  UiMap& ui_map_;
  std::vector<std::string> names_;
  long seen_revision_ = -1;
};

}  // namespace inkbench
