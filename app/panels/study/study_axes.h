// SPDX-License-Identifier: MIT
// The axes of a study's form: which parameter, from where to where, in how many steps.
#pragma once

#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

/// Draws into the current ImGui window, as wide as it is.
void draw_study_axes(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map,
                     StudyForm& form, const CheckedForm& checked);

}  // namespace inkbench
