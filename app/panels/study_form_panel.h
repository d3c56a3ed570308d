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
  void draw_form(Workbench& bench, const CheckedForm& checked);
  void draw_spec(Workbench& bench, const CheckedForm& checked);

  float fields_height_ = 0, foot_height_ = 0;  ///< As they were drawn last.
};

}  // namespace inkbench
