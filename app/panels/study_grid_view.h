// A study's cells in rows and columns as large as the room allows, or larger and scrolled. In: results. Out:
// which cell the mouse is on or pressed.
#pragma once

#include <optional>

#include "app/window/studies.h"
#include "app/window/thumbnails.h"
#include "app/window/workbench.h"

namespace inkbench {

/// What of the results is shown.
struct GridChoice {
  size_t picture = 0;  ///< Of each cell's pictures.
  size_t page = 0;
  std::optional<size_t> number;  ///< Below each cell.
  float zoom = 1.0F;             ///< 1 fits the grid into the room.
  std::optional<size_t> taken;   ///< The cell whose parameters were taken over last.
};

/// How far a grid is enlarged at most.
constexpr float kLargestGrid = 40.0F;

struct GridMouse {
  std::optional<size_t> clicked;
  std::optional<size_t> menu;  ///< Pressed with the right button.
};

/// Draws into the rest of the current ImGui window; only cells in sight are read and drawn.
GridMouse draw_study_grid(Workbench& bench, const StudyResults& results, GridChoice& choice,
                          Thumbnails& thumbnails);

}  // namespace inkbench
