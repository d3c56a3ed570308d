// SPDX-License-Identifier: MIT
// A finished study's charts, one below the other. In: their files. Out: which one was pressed.
#pragma once

#include <filesystem>
#include <vector>

#include "app/window/thumbnails.h"
#include "app/window/ui_map.h"
#include "studies/sweep/study_charts.h"

namespace inkbench {

/// Draws into the rest of the current ImGui window. `zoom`: 1 is as wide as the room; Ctrl and the wheel
/// change it. Returns the file to open of the chart that was clicked; empty without one.
std::filesystem::path draw_study_charts(UiMap& ui_map, const std::vector<DrawnChart>& charts, float& zoom,
                                        Thumbnails& thumbnails);

/// How far charts are enlarged at most.
constexpr float kLargestChart = 4.0F;

}  // namespace inkbench
