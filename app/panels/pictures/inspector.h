// SPDX-License-Identifier: MIT
// The panel beside the pictures: the selected buffer, how it is shown, and each buffer's value under the
// mouse.
#pragma once

#include "app/panels/pictures/histogram_view.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/workbench/document.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class InspectorPanel {
 public:
  /// All must outlive it.
  InspectorPanel(Document& document, Viewer& viewer, const WindowLayout& layout, ViewState& view,
                 UiMap& ui_map)
      : document_(document),
        viewer_(viewer),
        layout_(layout),
        view_(view),
        ui_map_(ui_map),
        histogram_(document, viewer, ui_map) {}

  void draw();

 private:
  void draw_pixel();

  Document& document_;
  Viewer& viewer_;
  const WindowLayout& layout_;
  ViewState& view_;
  UiMap& ui_map_;
  HistogramView histogram_;
  std::optional<HoveredPixel> pixel_;  ///< The last one under the mouse.
};

}  // namespace inkbench
