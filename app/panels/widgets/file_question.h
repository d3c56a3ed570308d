// SPDX-License-Identifier: MIT
// A question for a file's name, over the whole window. A name to save under that is taken is asked about, and
// one in a folder that is not there is told.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/window/ui_map.h"
#include "app/workbench/problems.h"

namespace inkbench {

struct PathQuestion {
  std::string title, hint, action;
  bool saves = false;  ///< The file need not be there; one that is gets replaced.
};

class FileQuestion {
 public:
  /// Both must outlive it.
  FileQuestion(Problems& problems, UiMap& ui_map) : problems_(problems), ui_map_(ui_map) {}

  /// Asks from the next frame on; `answer` gets the whole path, and what it throws is told as a problem.
  void ask(PathQuestion question, std::function<void(const std::string&)> answer);
  /// Once a frame.
  void draw();

 private:
  void draw_path();
  void draw_buttons();
  void accept();

  Problems& problems_;
  UiMap& ui_map_;
  PathQuestion question_;
  std::function<void(const std::string&)> answer_;
  bool opening_ = false, focus_ = false, entered_ = false;
  std::string path_, problem_;
  std::optional<std::filesystem::path> replaces_;  ///< Asked whether to write over it.
};

}  // namespace inkbench
