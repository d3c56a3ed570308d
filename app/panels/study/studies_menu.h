// The menu of studies: new ones, those that come with the program, any spec file or folder of results.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/widgets/file_question.h"
#include "app/window/workbench.h"

namespace inkbench {

class StudiesMenu {
 public:
  /// Between BeginMainMenuBar and EndMainMenuBar.
  void draw_menu(Workbench& bench);
  /// The question for a path, when it was asked for.
  void draw_question(Workbench& bench) { question_.draw(bench); }

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

  std::optional<std::vector<Folder>> bundled_;
  FileQuestion question_;
};

}  // namespace inkbench
