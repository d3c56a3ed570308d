// SPDX-License-Identifier: MIT
#include "app/panels/pictures/fitted_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace inkbench {

void draw_fitted_picture(ImDrawList& list, const Texture& texture, ImVec2 low, ImVec2 room) {
  const auto width = static_cast<float>(texture.width_px());
  const auto height = static_cast<float>(texture.height_px());
  const float scale = std::min(room.x / width, room.y / height);
  const bool fits = scale >= 1.0F && scale < 1.05F;
  const ImVec2 size{fits ? width : std::floor(width * scale), fits ? height : std::floor(height * scale)};
  const ImVec2 at{std::floor(low.x + (room.x - size.x) / 2), std::floor(low.y + (room.y - size.y) / 2)};
  list.AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture.id())), at,
                {at.x + size.x, at.y + size.y}, {0, 1}, {1, 0});
}

}  // namespace inkbench
