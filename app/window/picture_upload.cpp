// SPDX-License-Identifier: MIT
#include "app/window/picture_upload.h"

namespace inkbench {

Texture texture_of(const std::string& label, const Picture& picture) {
  Image image(picture.width_px, picture.height_px, 4, 1.0F);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) {
      for (int c = 0; c < picture.channels; ++c)
        image.at(x, y, c) = static_cast<float>(picture.at(x, y, c)) / 255.0F;
    }
  }
  Texture texture(label, TextureFormat::rgba8, picture.width_px, picture.height_px);
  texture.upload(image);
  return texture;
}

}  // namespace inkbench
