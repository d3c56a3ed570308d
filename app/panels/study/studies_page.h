// The page of studies, in the place of the pictures: a list on the left, beside it the form of a new study or
// the grid of one that runs or ran.
#pragma once

#include "app/panels/study/study_form_panel.h"
#include "app/panels/study/study_results_panel.h"
#include "app/window/workbench.h"

namespace inkbench {

class StudiesPage {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  StudyFormPanel form_;
  StudyResultsPanel results_;
};

/// Once a frame, whether the page is open or not: takes in how far studies are.
void follow_studies(Workbench& bench);

}  // namespace inkbench
