// The axes of a study's form: which parameter, from where to where, in how many steps.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// Draws into the current ImGui window, as wide as it is.
void draw_study_axes(Workbench& bench, StudyForm& form, const CheckedForm& checked);

}  // namespace inkbench
