// The panel beside the pictures: the inspector and the judge, one at a time.
#pragma once

#include "app/panels/judge/judge_view.h"
#include "app/panels/pictures/inspector.h"
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
