// SPDX-License-Identifier: MIT
// What a study's cell is, beside the mouse: its parameters, its numbers, a larger picture.
#pragma once

#include <imgui.h>

#include "app/window/thumbnails.h"
#include "app/workbench/study_results.h"

namespace inkbench {

/// `cell_size`: its picture's in the grid; `now`: the window's own image.
void draw_cell_tooltip(const StudyResults& results, size_t cell, size_t picture, Thumbnails& thumbnails,
                       ImVec2 cell_size, const ImageParams& now);

}  // namespace inkbench
