// SPDX-License-Identifier: MIT
// One parameter as a row: a mark where it was changed, its name, and the editor that its description asks
// for.
#pragma once

#include <string>

#include "app/window/fit_desk.h"
#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

struct RowContext {
  std::string key;
  const Field* field = nullptr;
  Value value;
  Value baseline;        ///< What a reset gives.
  bool matters = true;   ///< Else drawn dim: nothing depends on it now.
  float name_width = 0;  ///< Of the column of names.
};

void parameter_row(Document& document, ViewState& view, Studies& studies, FitDesk& fit, Problems& problems,
                   UiMap& ui_map, const RowContext& row);

}  // namespace inkbench
