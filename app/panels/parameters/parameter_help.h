// SPDX-License-Identifier: MIT
// What hovering a parameter says: key, meaning, unit, limits, what it was, what makes it matter.
#pragma once

#include "app/panels/parameters/parameter_row.h"

namespace inkbench {

/// A tooltip for the last item, once the mouse rests on it.
void help_for_parameter(const RowContext& row);

}  // namespace inkbench
