// SPDX-License-Identifier: MIT
// The menu of studies: new ones, those that come with the program, any spec file or folder of results.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/widgets/file_question.h"
#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

class StudiesMenu {
 public:
  /// All must outlive it.
  StudiesMenu(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map)
      : document_(document),
        studies_(studies),
        problems_(problems),
        ui_map_(ui_map),
        question_(problems, ui_map) {}

  /// Between BeginMainMenuBar and EndMainMenuBar.
  void draw_menu();
  /// The question for a path, when it was asked for.
  void draw_question() { question_.draw(); }

 private:
  struct Bundled {
    std::filesystem::path file;
    std::string title, purpose;
  };
  struct Folder {
    std::string label;
    std::vector<Bundled> studies;
  };
  void read_bundled();

  const Document& document_;
  Studies& studies_;
  Problems& problems_;
  UiMap& ui_map_;
  std::optional<std::vector<Folder>> bundled_;
  FileQuestion question_;
};

}  // namespace inkbench
