// SPDX-License-Identifier: MIT
// The form of a study: what to sweep and show, beside it the spec that comes of it, as text that can be
// written by hand as well.
#pragma once

#include <string>
#include <vector>

#include "app/window/pass_timer.h"
#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

class StudyFormPanel {
 public:
  /// All must outlive it.
  StudyFormPanel(const Document& document, const PassTimer& timer, Studies& studies, Problems& problems,
                 WindowRequests& requests, UiMap& ui_map)
      : document_(document),
        timer_(timer),
        studies_(studies),
        problems_(problems),
        requests_(requests),
        ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  void plan_lines(const CheckedForm& checked);
  void run_buttons(const CheckedForm& checked);
  void remember(const StudyForm& form, const CheckedForm& checked);
  /// What is shown of the spec: while a value is not valid, what it was before.
  const CheckedForm& shown(const StudyForm& form, const CheckedForm& checked) const;
  void draw_form(const CheckedForm& checked);
  void draw_spec(const CheckedForm& checked);

  const Document& document_;
  const PassTimer& timer_;
  Studies& studies_;
  Problems& problems_;
  WindowRequests& requests_;
  UiMap& ui_map_;
  struct {
    std::vector<std::string> keys;  ///< Of its axes: with others it is another study.
    CheckedForm checked;
  } last_good_;
  std::string large_;        ///< Why to ask before the study runs; empty where it is of usual size.
  std::string asked_about_;  ///< The spec that was to run and waits for the answer.
  float fields_height_ = 0, foot_height_ = 0;  ///< As they were drawn last.
};

}  // namespace inkbench
