// A question for a file's name, over the whole window.
#pragma once

#include <functional>
#include <string>

#include "app/window/workbench.h"

namespace inkbench {

class FileQuestion {
 public:
  /// Asks from the next frame on; `answer` gets the name, and what it throws is told as a problem.
  void ask(const std::string& title, const std::string& hint, const std::string& action,
           std::function<void(const std::string&)> answer);
  /// Once a frame.
  void draw(Workbench& bench);

 private:
  void close_with(Workbench& bench, bool accepted);

  bool opening_ = false;
  int frames_to_settle_ = 0;
  std::string title_, hint_, action_, path_;
  std::function<void(const std::string&)> answer_;
};

}  // namespace inkbench
