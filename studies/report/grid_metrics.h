// SPDX-License-Identifier: MIT
// The sizes of everything in the image grid: cells, type, gaps, and how many cells a sheet holds. In: a
// GridLayout. Out: the metrics that all sheets of one grid share, for grid_plan.cpp to place things by.
#pragma once

#include <string>
#include <vector>

#include "studies/report/grid.h"
#include "studies/report/lettering.h"

namespace inkbench {

inline constexpr int kSmallestText = 14;  // Below this, hinted letters run together.

/// What stands on one sheet: counts of columns and rows. `flow`: one axis, run on like text, values above
/// cells.
struct GridCounts {
  bool flow = false;
  int columns = 0;
  int rows = 0;
};

/// Some text at one size. Its lines are found again where it is placed.
struct TextBlock {
  int size_px = kSmallestText;
  int width_px = 0;
  int max_lines = 0;
  int height_px = 0;
};

/// Every size that sheets of one plan share.
struct GridMetrics {
  GridCounts counts;
  int cell_width_px = 0, cell_height_px = 0;
  int slot_width_px = 0, slot_height_px = 0;  // A slot holds a cell, and is larger where its labels are.
  int body_px = kSmallestText;
  int gutter_px = 0, frame_px = 1, margin_px = 0;
  int value_px = kSmallestText;  // Text size of the values along both axes.
  TextBlock title, subtitle, column_label, row_label;
  int column_values_height_px = 0;  // With the gap to the cells; above all rows, or in a flow above each.
  int row_values_width_px = 0;
  int left_px = 0, top_px = 0;  // Where the cells begin, of a flow the first values.
  int width_px = 0, height_px = 0;

  int value_width_px() const { return slot_width_px * 24 / 25; }
  int block_width_px() const { return counts.columns * slot_width_px + (counts.columns - 1) * gutter_px; }
  int row_pitch_px() const {
    return slot_height_px + row_gap_px() + (counts.flow ? column_values_height_px : 0);
  }
  int row_gap_px() const {
    return counts.flow && column_values_height_px > 0 ? gutter_px + value_px / 2 : gutter_px;
  }
  int block_height_px() const { return counts.rows * row_pitch_px() - row_gap_px(); }
};

/// The axis that runs on as a flow, or nullptr for a matrix of columns and rows.
const GridAxis* flow_axis(const GridLayout& layout);

/// The lines of `text` in `block`, none for an empty text. The last one ends in an ellipsis where the text is
/// longer than a sheet can take.
std::vector<std::string> block_lines(const std::string& text, const TextBlock& block, Face face);

/// The line below the title: the page, the layout's own subtitle, and `part`.
std::string subtitle_text(const GridLayout& layout, int page, const std::string& part);

/// The metrics with the largest cells with which a sheet holds all cells of a page; else with the smallest
/// allowed and as many of them as a sheet holds.
GridMetrics fitted_metrics(const GridLayout& layout);

}  // namespace inkbench
