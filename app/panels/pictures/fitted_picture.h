// SPDX-License-Identifier: MIT
// A picture in a rectangle, as large as it fits.
#pragma once

#include <imgui.h>

#include "pipeline/gl/texture.h"

namespace inkbench {

/// In the middle of the rectangle from `low` on. One to one where it was made for this size; else stretched:
/// the one of another size that is shown until the right one is read.
void draw_fitted_picture(ImDrawList& list, const Texture& texture, ImVec2 low, ImVec2 room);

}  // namespace inkbench
