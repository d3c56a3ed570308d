// The panel beside the pictures: the inspector and the judge, one at a time.
#pragma once

#include "app/panels/inspector.h"
#include "app/panels/judge_view.h"
#include "app/window/workbench.h"

namespace inkbench {

class SidePanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  InspectorPanel inspector_;
  JudgeView judge_;
};

}  // namespace inkbench
