// The menu bar.
#pragma once

#include "app/panels/study/studies_menu.h"
#include "app/window/workbench.h"

namespace inkbench {

class MenuBar {
 public:
  void draw(Workbench& bench);
  /// Of the bar, in pixels; after `draw`.
  float height() const { return height_; }

 private:
  void file_menu(Workbench& bench);
  void view_menu(Workbench& bench);

  StudiesMenu studies_;
  float height_ = 0;
};

}  // namespace inkbench
