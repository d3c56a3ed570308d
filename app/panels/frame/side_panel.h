// SPDX-License-Identifier: MIT
// The panel beside the pictures: the inspector and the judge, one at a time.
#pragma once

#include "app/panels/judge/judge_view.h"
#include "app/panels/pictures/inspector.h"
#include "app/window/ui_map.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class SidePanel {
 public:
  /// All must outlive it.
  SidePanel(WindowLayout& layout, UiMap& ui_map, InspectorPanel& inspector, JudgeView& judge)
      : layout_(layout), ui_map_(ui_map), inspector_(inspector), judge_(judge) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  WindowLayout& layout_;
  UiMap& ui_map_;
  InspectorPanel& inspector_;
  JudgeView& judge_;
};

}  // namespace inkbench
