// The whole window: where the panels are, the dividers between them, and each panel's turn.
#pragma once

#include "app/panels/file_dialogs.h"
#include "app/panels/inspector.h"
#include "app/panels/left_panel.h"
#include "app/panels/log.h"
#include "app/panels/menu_bar.h"
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
  InspectorPanel inspector_;
  LogPanel log_;
};

}  // namespace inkbench
