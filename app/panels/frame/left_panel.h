// The panel on the left: parameters, presets, the history or cameras, chosen by tabs in its heading.
#pragma once

#include "app/panels/frame/history_panel.h"
#include "app/panels/frame/presets_panel.h"
#include "app/panels/parameters/parameters.h"
#include "app/panels/pictures/views_panel.h"
#include "app/window/workbench.h"

namespace inkbench {

class LeftPanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);
  /// Shows the parameters with the cursor in their search box.
  void focus_search(Workbench& bench);

 private:
  ParametersPanel parameters_;
  PresetsPanel presets_;
  HistoryPanel history_;
  ViewsPanel views_;
};

}  // namespace inkbench
