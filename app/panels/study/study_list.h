// The list of studies: what runs, what waits, what ran, newest first.
#pragma once

#include <string>

#include "app/window/workbench.h"

namespace inkbench {

/// Draws into the current ImGui window.
void draw_study_list(Workbench& bench);

/// "12 of 49 cells, 3 s left", "stopped after 12 of 49 cells": how far it is.
std::string state_text(const ListedStudy& study);

}  // namespace inkbench
