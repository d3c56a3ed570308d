// SPDX-License-Identifier: MIT
// Fitting parameters to the reference lines: what may move, how the search goes, what it found.
#pragma once

#include "app/window/fit_desk.h"
#include "app/window/keeping.h"
#include "app/window/ui_map.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

class FitPanel {
 public:
  /// All must outlive it.
  FitPanel(Document& document, FitDesk& fit, const Keeping& keeping, Problems& problems, UiMap& ui_map)
      : document_(document), fit_(fit), keeping_(keeping), problems_(problems), ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  void draw_mark_choices();
  void draw_start();
  void draw_choices();
  void draw_running();
  void draw_found();
  void draw_notes(const FitResult& found);
  void draw_found_buttons(const FitResult& found);

  Document& document_;
  FitDesk& fit_;
  const Keeping& keeping_;
  Problems& problems_;
  UiMap& ui_map_;
  bool shows_choices_ = false;
};

/// Once a frame, whatever is shown: takes in what the search tells, and says when it is over.
void follow_fit(FitDesk& fit, const Document& document, Problems& problems, WindowRequests& requests);

}  // namespace inkbench
