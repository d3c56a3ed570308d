// SPDX-License-Identifier: MIT
#include "pipeline/passes/strokes/brush_image.h"

#include <algorithm>

#include "pipeline/base/files.h"
#include "pipeline/image/image_file.h"

namespace inkbench {
namespace {

/// Half as wide, or half as high; an odd last pixel goes into the one before.
Image halved(const Image& image, bool across) {
  const int width = across ? image.width_px : image.width_px / 2;
  const int height = across ? image.height_px / 2 : image.height_px;
  Image half(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float first = across ? image.at(x, 2 * y) : image.at(2 * x, y);
      half.at(x, y) = 0.5F * (first + (across ? image.at(x, 2 * y + 1) : image.at(2 * x + 1, y)));
    }
  }
  return half;
}

}  // namespace

Image brush_paint(const std::string& path) {
  if (path.empty()) return {1, 1, 1, 1.0F};
  const Image image = read_grey_and_alpha(path);
  Image paint(image.width_px, image.height_px, 1);
  for (size_t i = 0; i < paint.samples.size(); ++i) {
    const float value = image.samples[i * image.channels + image.channels - 1];
    paint.samples[i] = std::clamp(image.channels == 2 ? value : 1.0F - value, 0.0F, 1.0F);
  }
  return paint;
}

Key brush_image_key(const std::string& path) {
  return KeyBuilder().add(path.empty() ? "" : read_file(path, kMostImageBytes)).key();
}

Image reduced_paint(Image paint, float along_px, float across_px) {
  while (paint.width_px > 1 && static_cast<float>(paint.width_px) > 2.0F * along_px)
    paint = halved(paint, false);
  while (paint.height_px > 1 && static_cast<float>(paint.height_px) > 2.0F * across_px)
    paint = halved(paint, true);
  return paint;
}

}  // namespace inkbench
