// The whole window: where the panels are, the dividers between them, and each panel's turn.
#pragma once

#include "app/panels/frame/file_dialogs.h"
#include "app/panels/frame/left_panel.h"
#include "app/panels/frame/log_panel.h"
#include "app/panels/frame/menu_bar.h"
#include "app/panels/frame/side_panel.h"
#include "app/panels/parameters/ramp_editor.h"
#include "app/panels/study/studies_page.h"
#include "app/window/workbench.h"

namespace inkbench {

class MainFrame {
 public:
  /// Between ImGui's NewFrame and Render.
  void draw(Workbench& bench);

 private:
  struct Places;
  Places arrange(Workbench& bench) const;
  void draw_dividers(Workbench& bench, const Places& places);
  void draw_bottom(Workbench& bench, const Places& places);

  MenuBar menu_bar_;
  LeftPanel left_;
  FileDialogs dialogs_;
  SidePanel side_panel_;
  LogPanel log_;
  StudiesPage studies_;
  RampEditor ramp_editor_;
};

}  // namespace inkbench
