// SPDX-License-Identifier: MIT
// A ball that shows where a light comes from, and that is turned to move it.
#pragma once

#include "app/panels/parameters/parameter_row.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"

namespace inkbench {

/// Whether the row is a light's direction.
bool is_light_direction(const RowContext& row);

/// Below the row's numbers: the ball as the camera sees it, lit by this light alone. Dragging turns the light
/// about the ball; one drag is one step.
void light_ball(Document& document, UiMap& ui_map, const RowContext& row);

}  // namespace inkbench
