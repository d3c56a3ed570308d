// SPDX-License-Identifier: MIT
// The list of studies: what runs, what waits, what ran, newest first.
#pragma once

#include <string>

#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

/// Draws into the current ImGui window.
void draw_study_list(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map);

/// "12 of 49 cells, 3 s left", "stopped after 12 of 49 cells": how far it is.
std::string state_text(const ListedStudy& study);

}  // namespace inkbench
