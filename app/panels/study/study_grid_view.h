// SPDX-License-Identifier: MIT
// A study's cells in rows and columns as large as the room allows, or larger and scrolled. In: results. Out:
// which cell the mouse is on or pressed.
#pragma once

#include <optional>

#include "app/panels/study/study_grid_plan.h"
#include "app/window/thumbnails.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"

namespace inkbench {

/// How far a grid is enlarged at most.
constexpr float kLargestGrid = 40.0F;

struct GridMouse {
  std::optional<size_t> clicked;
  std::optional<size_t> menu;  ///< Pressed with the right button.
};

/// Draws into the rest of the current ImGui window; only cells in sight are read and drawn.
GridMouse draw_study_grid(const Document& document, UiMap& ui_map, const StudyResults& results,
                          GridChoice& choice, Thumbnails& thumbnails);

}  // namespace inkbench
