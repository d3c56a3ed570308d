// SPDX-License-Identifier: MIT
// The panel on the left: parameters, presets, the history or cameras, chosen by tabs in its heading.
#pragma once

#include "app/panels/frame/history_panel.h"
#include "app/panels/frame/presets_panel.h"
#include "app/panels/parameters/parameters.h"
#include "app/panels/pictures/views_panel.h"
#include "app/window/ui_map.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class LeftPanel {
 public:
  /// All must outlive it.
  LeftPanel(WindowLayout& layout, UiMap& ui_map, ParametersPanel& parameters, PresetsPanel& presets,
            HistoryPanel& history, ViewsPanel& views)
      : layout_(layout),
        ui_map_(ui_map),
        parameters_(parameters),
        presets_(presets),
        history_(history),
        views_(views) {}

  /// Draws into the current ImGui window.
  void draw();
  /// Shows the parameters with the cursor in their search box.
  void focus_search();

 private:
  WindowLayout& layout_;
  UiMap& ui_map_;
  ParametersPanel& parameters_;
  PresetsPanel& presets_;
  HistoryPanel& history_;
  ViewsPanel& views_;
};

}  // namespace inkbench
