// SPDX-License-Identifier: MIT
// Where a study's cells stand in the window. In: its results, what of them is wanted, the room. Out: the size
// and place of cells, labels and captions.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>
#include <string>

#include "app/workbench/study_results.h"

namespace inkbench {

/// What of the results is shown.
struct GridChoice {
  size_t picture = 0;  ///< Of each cell's pictures.
  size_t page = 0;
  std::optional<size_t> number;  ///< Below each cell.
  float zoom = 1.0F;             ///< 1 fits the grid into the room.
  std::optional<size_t> taken;   ///< The cell whose parameters were taken over last.
};

/// A single row that is long runs on like text: each cell then has its value above it.
struct GridPlan {
  size_t columns = 1, rows = 1;  ///< As laid out.
  size_t count = 1;              ///< Cells of the page.
  bool flows = false;
  ImVec2 cell;  ///< Of a picture, in pixels.
  float gap = 0, value_height = 0, caption_height = 0;
  int digits = 1;           ///< That the columns' values need to differ.
  float left = 0, top = 0;  ///< Where the cells begin: what labels take.

  float across() const { return cell.x + gap; }
  float down() const { return cell.y + caption_height + (flows ? value_height : 0) + gap; }
  ImVec2 size() const {
    return {left + across() * static_cast<float>(columns) - gap,
            top + down() * static_cast<float>(rows) - gap};
  }
};

GridPlan plan_of(const StudyResults& results, const GridChoice& choice, ImVec2 room);

/// A value with as many digits as there is room for, and no fewer than `least`.
std::string fitting_value(const std::string& text, float width, int least);

}  // namespace inkbench
