// SPDX-License-Identifier: MIT
// The line at the bottom: scene, size, zoom, renderer, how long a frame takes.
#pragma once

#include "app/window/studies.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/workbench/document.h"

namespace inkbench {

void draw_status_bar(const Document& document, const Viewer& viewer, const ViewState& view,
                     const Studies& studies);

}  // namespace inkbench
