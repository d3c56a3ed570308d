// The form of a study: what to sweep and show, beside it the spec that comes of it, as text that can be
// written by hand as well.
#pragma once

#include <string>
#include <vector>

#include "app/window/workbench.h"

namespace inkbench {

class StudyFormPanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  void plan_lines(Workbench& bench, const CheckedForm& checked);
  void run_buttons(Workbench& bench, const CheckedForm& checked);
  void remember(const StudyForm& form, const CheckedForm& checked);
  /// What is shown of the spec: while a value is not valid, what it was before.
  const CheckedForm& shown(const StudyForm& form, const CheckedForm& checked) const;
  void draw_form(Workbench& bench, const CheckedForm& checked);
  void draw_spec(Workbench& bench, const CheckedForm& checked);

  struct {
    std::vector<std::string> keys;  ///< Of its axes: with others it is another study.
    CheckedForm checked;
  } last_good_;
  std::string large_;        ///< Why to ask before the study runs; empty where it is of usual size.
  std::string asked_about_;  ///< The spec that was to run and waits for the answer.
  float fields_height_ = 0, foot_height_ = 0;  ///< As they were drawn last.
};

}  // namespace inkbench
