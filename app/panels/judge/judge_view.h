// The panel that judges the drawn lines against the reference lines: the measures of a study, live, and how
// they differ from the pinned state's.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

class JudgeView {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  void draw_state(Workbench& bench);

  double behind_since_ = -1.0;
  bool pin_compares_ = false;  ///< Changes of another view's measures would be the camera's.
};

}  // namespace inkbench
