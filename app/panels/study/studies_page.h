// SPDX-License-Identifier: MIT
// The page of studies, in the place of the pictures: a list on the left, beside it the form of a new study or
// the grid of one that runs or ran.
#pragma once

#include "app/panels/study/study_form_panel.h"
#include "app/panels/study/study_results_panel.h"
#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/window/viewer.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

class StudiesPage {
 public:
  /// All must outlive it.
  StudiesPage(Document& document, Viewer& viewer, Studies& studies, Problems& problems,
              WindowRequests& requests, UiMap& ui_map)
      : document_(document),
        viewer_(viewer),
        studies_(studies),
        problems_(problems),
        ui_map_(ui_map),
        form_(document, viewer.timer, studies, problems, requests, ui_map),
        results_(document, studies, problems, requests, ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  Document& document_;
  Viewer& viewer_;
  Studies& studies_;
  Problems& problems_;
  UiMap& ui_map_;
  StudyFormPanel form_;
  StudyResultsPanel results_;
};

/// Once a frame, whether the page is open or not: takes in how far studies are.
void follow_studies(Studies& studies, Problems& problems, WindowRequests& requests);

}  // namespace inkbench
