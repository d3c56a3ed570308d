// SPDX-License-Identifier: MIT
// A question for a file's name, over the whole window.
#pragma once

#include <functional>
#include <string>

#include "app/window/ui_map.h"
#include "app/window/window_requests.h"
#include "app/workbench/problems.h"

namespace inkbench {

class FileQuestion {
 public:
  /// All must outlive it.
  FileQuestion(Problems& problems, WindowRequests& requests, UiMap& ui_map)
      : problems_(problems), requests_(requests), ui_map_(ui_map) {}

  /// Asks from the next frame on; `answer` gets the name, and what it throws is told as a problem.
  void ask(const std::string& title, const std::string& hint, const std::string& action,
           std::function<void(const std::string&)> answer);
  /// Once a frame.
  void draw();

 private:
  void close_with(bool accepted);

  Problems& problems_;
  WindowRequests& requests_;
  UiMap& ui_map_;
  bool opening_ = false;
  int frames_to_settle_ = 0;
  std::string title_, hint_, action_, path_;
  std::function<void(const std::string&)> answer_;
};

}  // namespace inkbench
