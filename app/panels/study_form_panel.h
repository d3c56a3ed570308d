// The form of a study: what to sweep and show, beside it the spec that comes of it, as text that can be
// written by hand as well.
#pragma once

#include <string>

#include "app/window/workbench.h"

namespace inkbench {

class StudyFormPanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  void draw_spec(Workbench& bench, const CheckedForm& checked);
};

}  // namespace inkbench
