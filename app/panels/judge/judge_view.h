// SPDX-License-Identifier: MIT
// The panel that judges the drawn lines against the reference lines: the measures of a study, live, and how
// they differ from the pinned state's.
#pragma once

#include "app/panels/judge/fit_panel.h"
#include "app/window/ui_map.h"
#include "app/window/viewer.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class JudgeView {
 public:
  /// All must outlive it.
  JudgeView(const Document& document, Viewer& viewer, FitPanel& fit, WindowLayout& layout,
            WindowRequests& requests, UiMap& ui_map)
      : document_(document),
        viewer_(viewer),
        fit_(fit),
        layout_(layout),
        requests_(requests),
        ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  void draw_state();

  const Document& document_;
  Viewer& viewer_;
  FitPanel& fit_;
  WindowLayout& layout_;
  WindowRequests& requests_;
  UiMap& ui_map_;
  double behind_since_ = -1.0;
  bool pin_compares_ = false;  ///< Changes of another view's measures would be the camera's.
};

}  // namespace inkbench
