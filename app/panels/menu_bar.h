// The menu bar, and the small window in which a file's path is typed.
#pragma once

#include <string>

#include "app/panels/studies_menu.h"
#include "app/window/workbench.h"

namespace inkbench {

class MenuBar {
 public:
  void draw(Workbench& bench);
  void ask_for_file() { asking_ = true; }
  /// Of the bar, in pixels; after `draw`.
  float height() const { return height_; }

 private:
  void file_menu(Workbench& bench);
  void view_menu(Workbench& bench);
  void draw_file_question(Workbench& bench);

  StudiesMenu studies_;
  bool asking_ = false;
  std::string path_;
  float height_ = 0;
};

}  // namespace inkbench
