// SPDX-License-Identifier: MIT
// The View menu: panels, pinning and comparing, what is laid over the pictures, the look of the window.
#pragma once

#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class ViewMenu {
 public:
  /// All must outlive it.
  ViewMenu(Document& document, Viewer& viewer, WindowLayout& layout, ViewState& view, Problems& problems,
           WindowRequests& requests, UiMap& ui_map)
      : document_(document),
        viewer_(viewer),
        layout_(layout),
        view_(view),
        problems_(problems),
        requests_(requests),
        ui_map_(ui_map) {}

  /// Between BeginMainMenuBar and EndMainMenuBar.
  void draw();

 private:
  Document& document_;
  Viewer& viewer_;
  WindowLayout& layout_;
  ViewState& view_;
  Problems& problems_;
  WindowRequests& requests_;
  UiMap& ui_map_;
};

}  // namespace inkbench
