// SPDX-License-Identifier: MIT
// What an image is that was opened and says nothing of itself: asked over the whole window before anything
// changes.
#pragma once

#include "app/window/ui_map.h"
#include "app/window/window_requests.h"
#include "app/workbench/file_opener.h"

namespace inkbench {

/// Once a frame; asks about the image that `files` was given, if there is one.
void draw_image_question(FileOpener& files, WindowRequests& requests, UiMap& ui_map);

}  // namespace inkbench
